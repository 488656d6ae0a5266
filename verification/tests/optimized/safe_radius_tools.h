// Tools and nodes for the tests of how long a decision holds.
#pragma once

#include "verification/tests/optimized/test_tools.h"

namespace type21::optimized::testing {

inline constexpr double largest_reach = 0.15;

inline std::vector<Tool> safe_radius_tools() {
    std::vector<Tool> made;
    for (const bool triangles : {false, true}) {
        made.push_back(grid(
            6, [](double, double) { return 0.0; }, triangles));
        made.push_back(grid(
            6, [](double x, double y) { return 0.5 * (x * x + y * y); }, triangles, 0.25));
        made.push_back(grid(
            6, [](double x, double y) { return 0.2 * std::sin(4 * x) * std::cos(3 * y); }, triangles, 0.2));
        made.push_back(grid(
            6, [](double x, double) { return -0.7 * std::abs(x); }, triangles, 0.1));
    }
    return made;
}

/// Anywhere over a sub-triangle, a little beyond its sides, too.
inline V3 somewhere_over(const Tool& tool, std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-0.2, 1), height(-1.3 * largest_reach, 1.3 * largest_reach);
    const SegmentData s = tool.segment(static_cast<int>(random() % static_cast<unsigned>(tool.size())));
    double b = unit(random), c = unit(random);
    if (b + c > 1.2) {
        b = 1 - b;
        c = 1 - c;
    }
    const auto at = [&](const std::array<V3, 4>& v) { return v[2] * (1 - b - c) + v[0] * b + v[1] * c; };
    return at(s.node) + at(s.normal) * height(random);
}

inline V3 direction(std::mt19937_64& random) {
    std::normal_distribution<double> one;
    const V3 v{one(random), one(random), one(random)};
    return v * (1 / norm(v));
}

}  // namespace type21::optimized::testing
