// Bounds of a sub-triangle: how fast weights change as a node moves, and what kappa in double may be off by.
#include <gtest/gtest.h>

#include "optimized/projection/project_double_double.h"
#include "optimized/search/gather.h"
#include "optimized/search/weight_lipschitz.h"
#include "verification/tests/optimized/safe_radius_tools.h"

namespace type21::optimized {
namespace {

using testing::direction;
using testing::largest_reach;
using testing::safe_radius_tools;
using testing::somewhere_over;

TEST(WeightLipschitz, OfAFlatTriangleAreOneOverItsWidth) {
    // Right-angled, sides 3 and 4: the width is the height over the side of 5, 12 / 5.
    const std::vector<V3> x{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
    const Tool tool(x, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2, 2}});
    EXPECT_NEAR(double(lipschitz_bounds(tool, 0.5).lipschitz[0]), 5.0 / 12, 1e-5);
}

TEST(WeightLipschitz, AreTheSameBitsOnEachMachine) {
    for (const Tool& tool : safe_radius_tools()) {
        const LipschitzBounds two = lipschitz_bounds(tool, largest_reach, SimdWidth::two);
        for (const SimdWidth machine : {SimdWidth::four, SimdWidth::eight}) {
            if (machine > this_machine()) continue;
            EXPECT_TRUE(lipschitz_bounds(tool, largest_reach, machine) == two);
        }
    }
}

TEST(WeightLipschitz, BoundHowWeightsChange) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> way(0, 1e-3);
    auto rows = std::make_unique<ProjectionBatch>();
    double nearest = 0;  // share of the bound that is used
    for (const Tool& tool : safe_radius_tools()) {
        const std::vector<float> bounds = lipschitz_bounds(tool, largest_reach).lipschitz;
        for (int round = 0; round < 2000; ++round) {
            const V3 from = somewhere_over(tool, random), to = from + direction(random) * way(random);
            const SubTriangleId id(static_cast<int>(random() % static_cast<unsigned>(tool.size())), 1);
            const std::array<SubTriangleId, 2> ids{id, id};
            const std::array<V3, 2> y{from, to};
            for (size_t i = 0; i < 2; ++i)
                for (int a = 0; a < 3; ++a)
                    rows->y[a][i] = y[i][a];
            gather(*rows, tool, ids.data(), 0, 2, largest_reach);
            project_double(*rows, 0, 2, {largest_reach, largest_reach, largest_reach, 0, false});
            const double bound = double(bounds[static_cast<size_t>(id.code())]);
            const auto weights = [&](size_t i) {
                return std::array<double, 6>{rows->weight[0][i], rows->weight[1][i], rows->weight[2][i],
                                             rows->b[i],         rows->c[i],         1 - rows->b[i] - rows->c[i]};
            };
            const auto w = weights(0), v = weights(1);
            const double height = std::abs(rows->height[0]) / std::sqrt(rows->square[0]);
            if (!(std::min({w[0], w[1], w[2]}) > -lipschitz_weights + 0.01) || !(height < largest_reach) ||
                bound >= no_lipschitz)
                continue;
            for (size_t k = 0; k < 6; ++k) {
                EXPECT_LE(std::abs(v[k] - w[k]), bound * norm(to - from) * (1 + 1e-9) + 1e-12);
                nearest = std::max(nearest, std::abs(v[k] - w[k]) / (bound * norm(to - from)));
            }
            const double change = std::abs(kappa_of(v[3], v[4]) - kappa_of(w[3], w[4]));
            EXPECT_LE(change, 2 * bound * norm(to - from) * (1 + 1e-9) + 1e-12);
        }
    }
    EXPECT_GT(nearest, 0.8);
}

/// Against double-double, with nodes in the range that the bounds hold for.
TEST(WeightLipschitz, BoundTheErrorOfKappa) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    auto rows = std::make_unique<ProjectionBatch>();
    double nearest = 0;
    int judged = 0;
    for (const Tool& tool : safe_radius_tools()) {
        for (const double growth : {1e-4, largest_reach}) {
            const LipschitzBounds bounds = lipschitz_bounds(tool, growth);
            for (int round = 0; round < 4000; ++round) {
                const int segment = static_cast<int>(random() % static_cast<unsigned>(tool.size()));
                const SegmentData data = tool.segment(segment);
                const int triangle = 1 + static_cast<int>(random() % static_cast<unsigned>(data.sub_triangles()));
                const SubTriangleId id(segment, triangle);
                if (!std::isfinite(bounds.lipschitz[static_cast<size_t>(id.code())])) continue;
                const double b = unit(random), c = (1 - b) * unit(random);
                const SubTriangleCorners of = sub_triangle_corners(data.is_triangle, triangle);
                const V3 y = point_at(data, triangle, b, c) +
                             data.normal[static_cast<size_t>(of.b)] * (growth * (2 * unit(random) - 1));
                for (int a = 0; a < 3; ++a)
                    rows->y[a][0] = y[a];
                gather(*rows, tool, &id, 0, 1, growth);
                project_double(*rows, 0, 1, {growth, growth, growth, 0, false});
                KappaDoubleDouble precise;
                if (filter_double_double(y, data, triangle, {growth, growth, 0}, {}, precise).verdict != Verdict::taken)
                    continue;
                ++judged;
                const double off = std::abs((TwoDoubles(kappa_of(rows->b[0], rows->c[0])) - precise.value).high);
                const double bound = std::ldexp(1.0, -int(bounds.kappa_bits[static_cast<size_t>(segment)]));
                ASSERT_LE(off, bound);
                nearest = std::max(nearest, off / bound);
            }
        }
    }
    EXPECT_GT(judged, 20000);
    EXPECT_GT(nearest, 3e-4);  // a bound is the sum of the worst of many steps
}

}  // namespace
}  // namespace type21::optimized
