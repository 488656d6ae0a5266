// Magnitudes of a retained projection: doubles where their bounds are close, else the exact ones rounded.
#include <vector>

#include <gtest/gtest.h>

#include "reference/exact/magnitudes.h"

namespace type21::reference {
namespace {

constexpr double share_a = 0.5, share_b = 0.3, share_c = 0.2;
const std::vector<int> only{0};

/// A triangle in z = 0 whose corner normals all meet in (0, 0, 1). No coordinate is a whole multiple of a large power
/// of 2.
SegmentShape<double> cone(int) {
    SegmentShape<double> shape;
    shape.node = {Vec3(0.9, -0.1, 0), Vec3(0.1, 0.9, 0), Vec3(-0.3, -0.7, 0), Vec3(-0.3, -0.7, 0)};
    for (size_t j = 0; j < 4; ++j)
        shape.normal[j] = Vec3(-shape.node[j].x(), -shape.node[j].y(), 1);
    shape.triangle = true;
    return shape;
}
const ShapeOf cones = cone;

/// The node that lies `below` the meeting point and on the normal of the point with the shares a, b, c.
Vec3 on_normal(double below) {
    const auto shape = cone(0);
    const Vec3 landing = share_a * shape.node[2] + share_b * shape.node[0] + share_c * shape.node[1];
    return {below * landing.x(), below * landing.y(), 1 - below};
}

ContactQuery query_over(const Vec3& p) {
    return {p, 1.5, 1.5, 0.0};
}
const CandidateSegments cone_only{only, cones};

bool same_bits(const Projection<double>& one, const Projection<double>& other) {
    return one.weights.b == other.weights.b && one.weights.c == other.weights.c && one.normal == other.normal &&
           one.height == other.height && one.slope == other.slope;
}

// The lifted triangle has the same form and is 2^-52 times as large, so doubles keep a bit or two of its corners. The
// exact weights and normal are known all the same: they are those of the point whose normal the node lies on.
TEST(Magnitudes, WhereNormalsMeetTheyAreThoseOfTheDecision) {
    for (const double below : {0x1p-10, 0x1p-30, 0x1p-52}) {
        const auto impact = staged_impact(query_over(on_normal(below)), cone_only);
        ASSERT_EQ(impact.kind, Kind::contact) << below;
        EXPECT_NEAR(impact.projection.weights.b, share_b, 1e-9) << below;
        EXPECT_NEAR(impact.projection.weights.c, share_c, 1e-9) << below;
        const Vec3 landing = on_normal(below) / below;
        EXPECT_NEAR(impact.projection.normal.x(), -landing.x(), 1e-9) << below;
        EXPECT_NEAR(impact.projection.normal.y(), -landing.y(), 1e-9) << below;
    }
    const auto plain = double_impact(query_over(on_normal(0x1p-52)), cone_only);
    EXPECT_TRUE(plain.kind == Kind::none || std::abs(plain.projection.weights.b - share_b) > 0.01)
        << "double arithmetic can answer this query: the test shows nothing";
}

// Exact magnitudes differ in the last bit only, and they cost much. So doubles are used wherever they will do, whatever
// arithmetic the decision needed. The triangle lies in z = x: for a node there, a bound cannot tell the side.
TEST(Magnitudes, OrdinaryOnesAreDoubles) {
    const ShapeOf tilted = [](int) {
        auto shape = cone(0);
        for (size_t j = 0; j < 4; ++j) {
            shape.node[j].z() = shape.node[j].x();
            shape.normal[j] = Vec3(-0.7 + 0.1 * shape.node[j].x(), 0.1 * shape.node[j].y(), 0.7);
        }
        return shape;
    };
    int differ = 0;
    for (const double z : {0.0, 0.1, 0.3, 0.7, -0.1}) {
        const ContactQuery query = query_over({0.23, 0.03, 0.23 + z});
        const CandidateSegments candidates{only, tilted};
        const auto impact = staged_impact(query, candidates);
        ASSERT_EQ(impact.kind, Kind::contact) << z;
        EXPECT_EQ(impact.stage == Stage::bounded, z != 0.0) << z;
        EXPECT_TRUE(close_enough(query, tilted(0), 1)) << z;
        EXPECT_TRUE(same_bits(impact.projection, double_impact(query, candidates).projection)) << z;
        differ += same_bits(impact.projection, exact_impact(query, candidates).projection) ? 0 : 1;
    }
    EXPECT_GT(differ, 0) << "double and exact numbers are the same here: the test shows nothing";
}

TEST(Magnitudes, DoublesDoUntilNormalsNearlyMeet) {
    const auto double_will_do = [](double below) { return close_enough(query_over(on_normal(below)), cone(0), 1); };
    EXPECT_TRUE(double_will_do(0x1p-4));
    EXPECT_FALSE(double_will_do(0x1p-20)) << "n is known to some 2^-30, so delta is not to 2^-40";
    EXPECT_FALSE(double_will_do(0x1p-52));
}

// The limit is on the error as a length, not on its share of delta: on the surface delta is 0 and its bound is not.
TEST(Magnitudes, LimitsAreThoseOfTheBounds) {
    const auto projection = [](double b, double height) {
        Projection<Bounded> one;
        one.weights = {Bounded(1) / Bounded(b), Bounded(0.25)};
        one.normal = {Bounded(0), Bounded(0), Bounded(1)};
        one.height = Bounded(height) / Bounded(3) - Bounded(height / 3);
        one.slope = Bounded(1);
        return one;
    };
    EXPECT_TRUE(close_enough(projection(3, 1), 1));
    EXPECT_TRUE(close_enough(projection(3, 1), 0x1p-10));
    EXPECT_FALSE(close_enough(projection(3, 1), 0x1p-20)) << "the distance";
    EXPECT_FALSE(close_enough(projection(0x1p-30, 1), 1)) << "a weight";
    Projection<Bounded> turned = projection(3, 1);
    turned.normal.x() = Bounded(0x1p40) / Bounded(3) - Bounded(0x1p40 / 3);
    EXPECT_FALSE(close_enough(turned, 1)) << "the normal";
}

}  // namespace
}  // namespace type21::reference
