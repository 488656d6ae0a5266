// Bounds of a sub-triangle: how fast weights change as a node moves, and what kappa in double may be off by.
#include <gtest/gtest.h>

#include "optimized/projection/project_double_double.h"
#include "optimized/search/gather.h"
#include "optimized/search/weight_lipschitz.h"
#include "verification/tests/optimized/safe_radius_tools.h"

namespace type21::optimized {
namespace {

using testing::ball_tools;
using testing::direction;
using testing::reach;
using testing::somewhere_over;

TEST(Rates, OfAFlatTriangleAreOneOverItsWidth) {
    // Right-angled, sides 3 and 4: the width is the height over the side of 5, 12 / 5.
    const std::vector<V3> x{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
    const Tool tool(x, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2, 2}});
    EXPECT_NEAR(double(lipschitz_bounds(tool, 0.5).rate[0]), 5.0 / 12, 1e-5);
}

TEST(Rates, AreTheSameBitsOnEachMachine) {
    for (const Tool& tool : ball_tools()) {
        const LipschitzBounds two = lipschitz_bounds(tool, reach, SimdWidth::two);
        for (const SimdWidth machine : {SimdWidth::four, SimdWidth::eight}) {
            if (machine > this_machine()) continue;
            EXPECT_TRUE(lipschitz_bounds(tool, reach, machine) == two);
        }
    }
}

TEST(Rates, BoundHowWeightsChange) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> way(0, 1e-3);
    auto rows = std::make_unique<ProjectionBatch>();
    double nearest = 0;  // share of the bound that is used
    for (const Tool& tool : ball_tools()) {
        const std::vector<float> rates = lipschitz_bounds(tool, reach).rate;
        for (int round = 0; round < 2000; ++round) {
            const V3 from = somewhere_over(tool, random), to = from + direction(random) * way(random);
            const int place = place_of(static_cast<int>(random() % static_cast<unsigned>(tool.size())), 1);
            const std::array<int, 2> places{place, place};
            const std::array<V3, 2> y{from, to};
            for (size_t i = 0; i < 2; ++i)
                for (int a = 0; a < 3; ++a)
                    rows->y[a][i] = y[i][a];
            gather(*rows, tool, places.data(), 0, 2, reach);
            project_double(*rows, 0, 2, {reach, reach, reach, 0, false});
            const double rate = double(rates[static_cast<size_t>(place)]);
            const auto weights = [&](size_t i) {
                return std::array<double, 6>{rows->weight[0][i], rows->weight[1][i], rows->weight[2][i],
                                             rows->b[i],         rows->c[i],         1 - rows->b[i] - rows->c[i]};
            };
            const auto w = weights(0), v = weights(1);
            const double height = std::abs(rows->height[0]) / std::sqrt(rows->square[0]);
            if (!(std::min({w[0], w[1], w[2]}) > -rate_weights + 0.01) || !(height < reach) || rate >= no_rate)
                continue;
            for (size_t k = 0; k < 6; ++k) {
                EXPECT_LE(std::abs(v[k] - w[k]), rate * norm(to - from) * (1 + 1e-9) + 1e-12);
                nearest = std::max(nearest, std::abs(v[k] - w[k]) / (rate * norm(to - from)));
            }
            const double change = std::abs(kappa_of(v[3], v[4]) - kappa_of(w[3], w[4]));
            EXPECT_LE(change, 2 * rate * norm(to - from) * (1 + 1e-9) + 1e-12);
        }
    }
    EXPECT_GT(nearest, 0.8);
}

/// Against 100 bits, with nodes as near as the bounds are asked for.
TEST(Rates, BoundHowFarKappaIsOff) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    auto rows = std::make_unique<ProjectionBatch>();
    double nearest = 0;
    int judged = 0;
    for (const Tool& tool : ball_tools()) {
        for (const double growth : {1e-4, reach}) {
            const LipschitzBounds bounds = lipschitz_bounds(tool, growth);
            for (int round = 0; round < 4000; ++round) {
                const int segment = static_cast<int>(random() % static_cast<unsigned>(tool.size()));
                const SegmentData data = tool.segment(segment);
                const int piece = 1 + static_cast<int>(random() % static_cast<unsigned>(data.pieces()));
                const int place = place_of(segment, piece);
                if (!std::isfinite(bounds.rate[static_cast<size_t>(place)])) continue;
                const double b = unit(random), c = (1 - b) * unit(random);
                const PieceCorners of = piece_corners(data.triangle, piece);
                const V3 y = landed_at(data, piece, b, c) +
                             data.normal[static_cast<size_t>(of.b)] * (growth * (2 * unit(random) - 1));
                for (int a = 0; a < 3; ++a)
                    rows->y[a][0] = y[a];
                gather(*rows, tool, &place, 0, 1, growth);
                project_double(*rows, 0, 1, {growth, growth, growth, 0, false});
                FineKappa fine;
                if (fine_filter(y, data, piece, {growth, growth, 0}, {}, fine).verdict != Verdict::taken) continue;
                ++judged;
                const double off = std::abs((TwoDoubles(kappa_of(rows->b[0], rows->c[0])) - fine.value).high);
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
