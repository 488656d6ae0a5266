// Small tools for the tests of the optimized implementation.
#pragma once

#include <functional>
#include <random>

#include "optimized/projection/decide.h"
#include "optimized/search/tool.h"

namespace type21::optimized::testing {

/// A grid of n x n quads (or 2 n^2 triangles) over [-1, 1]^2 at height z(x, y), each inner vertex moved by up to
/// `shake` of an edge.
inline Tool grid(int n, const std::function<double(double, double)>& z, bool triangles = false, double shake = 0,
                 unsigned seed = 1) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> move(-shake * 2 / n, shake * 2 / n);
    std::vector<V3> position;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double x = -1 + 2.0 * i / n + move(random), y = -1 + 2.0 * j / n + move(random);
            position.push_back({x, y, z(x, y)});
        }
    }
    std::vector<std::array<int, 4>> corner;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            if (triangles) {
                corner.push_back({a, b, c, c});
                corner.push_back({a, c, d, d});
            } else {
                corner.push_back({a, b, c, d});
            }
        }
    }
    const std::vector<V3> normal = nodal_normals(position, corner);
    return {position, normal, corner};
}

/// Every sub-triangle of the tool in integers, without filter and search.
inline Retained exhaustive(
    const Tool& tool, const V3& p, const ContactReach& reach, const ProjectionLimits& rules,
    const std::function<bool(const SegmentData&)>& competes = [](const SegmentData&) { return true; }) {
    Retained best;
    ExactProjection least;
    for (int s = 0; s < tool.size(); ++s) {
        const SegmentData segment = tool.segment(s);
        if (!competes(segment)) continue;
        for (int k = 1; k <= segment.sub_triangles(); ++k) {
            ExactProjection one = project_exact(p, segment, k, reach, rules);
            if (!one.taken) continue;
            const bool other_kind =
                best.exists() && one.projection.kind != least.projection.kind && !rules.proximity_competes;
            const bool first =
                !best.exists() || (other_kind ? one.projection.kind == Kind::contact : compare_kappa(one, least) < 0);
            if (!first) continue;
            best = {{s, k}, one.projection, Settled::integer};
            least = std::move(one);
        }
    }
    return best;
}

inline ::testing::AssertionResult same(const Retained& one, const Retained& other) {
    if (one.id == other.id && (!one.exists() || (one.projection.kind == other.projection.kind &&
                                                 one.projection.side == other.projection.side)))
        return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "segment " << one.id.segment() << " sub-triangle " << one.id.triangle()
                                         << " side " << one.projection.side << ", and segment " << other.id.segment()
                                         << " sub-triangle " << other.id.triangle() << " side "
                                         << other.projection.side;
}

}  // namespace type21::optimized::testing
