#include <cmath>

#include <gtest/gtest.h>

#include "verification/performance/accuracy/exact_answer.h"

namespace type21::accuracy {
namespace {

/// A triangle in z = 0 with upright normals.
DecisionTool upright() {
    DecisionTool tool;
    tool.node = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    tool.normal.assign(3, Vec3::UnitZ());
    tool.segment = {{0, 1, 2, 2}};
    return tool;
}

TEST(ExactAnswer, OverAFlatTriangleItIsTheHeight) {
    const ExactAnswer exact = exact_answer_of(upright(), {{0.25, 0.25, 0.375}, 0.5, 0.5, 0});
    EXPECT_EQ(exact.answer.kind, Kind::contact);
    ASSERT_TRUE(exact.forced);
    EXPECT_EQ(exact.force, 125.0);
    EXPECT_EQ(exact.scale, 1000.0) << "k times the largest coordinate of the triangle";
    const ExactAnswer behind = exact_answer_of(upright(), {{0.25, 0.25, -0.25}, 0.5, 0.5, 0});
    EXPECT_EQ(behind.force, 750.0);
}

TEST(ExactAnswer, HasNoForceWithoutContactOrWithinRounding) {
    EXPECT_FALSE(exact_answer_of(upright(), {{0.25, 0.25, 0.75}, 0.5, 0.5, 0}).forced);
    EXPECT_FALSE(exact_answer_of(upright(), {{0.25, 0.25, 0.75}, 0.5, 0.5, 1.0}).forced) << "proximity";
    EXPECT_FALSE(exact_answer_of(upright(), {{0.25, 0.25, 0.5 - 8 * 0x1p-52}, 0.5, 0.5, 0}).forced);
    EXPECT_TRUE(exact_answer_of(upright(), {{0.25, 0.25, 0.5 - 32 * 0x1p-52}, 0.5, 0.5, 0}).forced);
}

// Roots to 40 digits by decimal arithmetic, which the compiler rounds once.
TEST(ExactAnswer, AnIrrationalForceIsRoundedOnce) {
    EXPECT_EQ(exact_force(1, 2, 1, 2, 1), 0.5857864376269049511983112757903019214303);
    EXPECT_EQ(exact_force(1, 0.5, -1, 3, 7), 0.7474358296526967562182066202151246238490);
    // Nearly all of it cancels: g is the double next to the root of 2. Plain doubles leave nothing of it.
    EXPECT_EQ(exact_force(1, std::sqrt(2.0), 1, 2, 1), 9.667293313452913037187168859825586e-17);
    EXPECT_EQ(exact_force(1000, std::sqrt(2.0), 1, 2, 1), 9.667293313452913037187168859825586e-14);
    EXPECT_EQ(exact_force(1, 3, 0, 2, 1), 3) << "on the surface";
}

}  // namespace
}  // namespace type21::accuracy
