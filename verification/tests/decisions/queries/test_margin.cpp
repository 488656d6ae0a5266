#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "verification/decisions/queries/decide.h"

namespace type21 {
namespace {

DecisionTool triangle(double leg) {
    return {{{leg, 0, 0}, {0, leg, 0}, {0, 0, 0}}, {Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitZ()}, {{0, 1, 2, 2}}};
}

// Above the middle of a right triangle with upright normals the weights of P are x and y, so the borders are planes:
// z = gap, z = 0, x = -0.01, y = -0.01, x + y = 1.01.
TEST(Margin, is_the_distance_to_the_nearest_border) {
    const auto margin_at = [](const Vec3& p) { return margin(triangle(1), {p, 0.25, 0.25, 0}); };
    EXPECT_NEAR(margin_at({0.25, 0.25, 0.2}), 0.05, 1e-15);
    EXPECT_NEAR(margin_at({0.25, 0.25, 0.02}), 0.02, 1e-15);
    EXPECT_NEAR(margin_at({0.005, 0.3, 0.125}), 0.015, 1e-15);
    EXPECT_NEAR(margin_at({0.5, 0.5, 0.125}), 0.01 / std::sqrt(2.0), 1e-15);
    EXPECT_EQ(margin_at({0.25, 0.25, 0.25}), 0);
}

// A power of two changes no digit, as long as nothing underflows: the margin scales with the picture.
TEST(Margin, scales_with_the_configuration_at_every_size) {
    const ContactQuery query{{0.3, 0.1, 0.2}, 0.25, 0.25, 0.4};
    const double expected = margin(triangle(1), query);
    ASSERT_GT(expected, 0);
    for (const int power : {-1000, -500, -60, 60, 500, 1000}) {
        const double scale = std::ldexp(1.0, power);
        const ContactQuery scaled{scale * query.point, scale * query.gap, scale * query.depth,
                                  scale * query.proximity_reach};
        EXPECT_EQ(margin(triangle(scale), scaled), scale * expected) << "2^" << power;
    }
}

TEST(Margin, is_infinite_where_there_is_no_tool) {
    EXPECT_EQ(margin({}, {{0, 0, 0}, 1, 1, 1}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace type21
