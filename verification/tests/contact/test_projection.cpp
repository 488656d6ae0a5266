// Each expected value is worked out by hand on a triangle of two unit legs (chapter 3 of the formulation).
#include <gtest/gtest.h>

#include "reference/contact/projection.h"
#include "reference/contact/retained_impact.h"

namespace type21::reference {
namespace {

const Vec3 up(0, 0, 1);

/// A = (0,0,0), B = (1,0,0), C = (0,1,0), N = (0,0,1).
SubTriangle<double> flat(const Vec3& na = up, const Vec3& nb = up, const Vec3& nc = up) {
    SubTriangle<double> t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, na, nb, nc, {}};
    t.area = (t.b - t.a).cross(t.c - t.a);
    return t;
}

const ProjectionLimits<double> documented;

TEST(Projection, WeightsAndHeightOnAFlatTriangle) {
    const auto p = project<double>({0.25, 0.5, 0.3}, flat(), documented);
    ASSERT_TRUE(p);
    EXPECT_DOUBLE_EQ(p->weights.b, 0.25);
    EXPECT_DOUBLE_EQ(p->weights.c, 0.5);
    EXPECT_DOUBLE_EQ(p->height, 0.3);
    EXPECT_DOUBLE_EQ(p->slope, 1.0);
}

// Normals that fan out: at height h the triangle is A' = A + n_A h, ... With n_B = (1,0,1) the corner B' = (1 + h, 0,
// h). P = (0.6, 0, 0.2): b' = 0.6 / 1.2 = 0.5, n = ((0,0,1) + (1,0,1)) / 2 = (0.5, 0, 1), Q = P - 0.2 n = (0.5, 0, 0).
TEST(Projection, FollowsTheInterpolatedNormal) {
    const auto p = project<double>({0.6, 0.0, 0.2}, flat(up, {1, 0, 1}, up), documented);
    ASSERT_TRUE(p);
    EXPECT_NEAR(p->weights.b, 0.5, 1e-15);
    EXPECT_NEAR(p->weights.c, 0.0, 1e-15);
    EXPECT_NEAR((p->normal - Vec3(0.5, 0, 1)).norm(), 0, 1e-15);
}

TEST(Projection, OnePercentOverTheEdgeIsStillInside) {
    EXPECT_TRUE(project<double>({-0.01, 0.3, 0.0}, flat(), documented));
    EXPECT_FALSE(project<double>({-0.0100001, 0.3, 0.0}, flat(), documented));
    EXPECT_TRUE(project<double>({0.5, 0.50999999, 0.0}, flat(), documented));
    EXPECT_FALSE(project<double>({0.5, 0.5100001, 0.0}, flat(), documented));
}

TEST(Projection, ANormalThatLeansOverRejectsOffThePlaneOnly) {
    const auto leaning = flat(up, {1, 0, 0}, up);  // <n_B, N> = 0
    EXPECT_FALSE(project<double>({0.25, 0.25, 0.1}, leaning, documented));
    EXPECT_TRUE(project<double>({0.25, 0.25, 0.0}, leaning, documented));  // H = 0: no lift is needed
}

// D35: the same triangle, lifted with 1e-30 in place of <n_B, N>, sends B' to 1e29: accepted only near b = 0.
// @manual departure D35
TEST(Projection, AsBuiltLiftsALeaningNormal) {
    ProjectionLimits<double> as_built;
    as_built.lift_leaning = true;
    EXPECT_TRUE(project<double>({0.0, 0.25, 0.1}, flat(up, {1, 0, 0}, up), as_built));
    EXPECT_FALSE(project<double>({0.0, 0.25, 0.1}, flat(up, {1, 0, 0}, up), documented));
}

TEST(Projection, ATurnedOverLiftRejects) {
    // n_B = (-1, 0, 1): at height 2 the corner B' = (-1, 0, 2) has passed A' = (0, 0, 2).
    EXPECT_FALSE(project<double>({-0.5, 0.1, 2.0}, flat(up, {-1, 0, 1}, up), documented));
}

TEST(Projection, ASubTriangleWithoutAreaRejects) {
    SubTriangle<double> needle{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, up, up, up, Vec3::Zero()};
    EXPECT_FALSE(project<double>({0.5, 0, 0.1}, needle, documented));
    EXPECT_FALSE(project<double>({0.5, 0, 0.0}, needle, documented));
}

TEST(Approach, DistanceToTheClippedPoint) {
    // b = -0.01, c = 0.3: clipped to (0, 0.3, 0.71 / 1.01 ...): a = 0.71, sum 1.01, the point is (0, 0.3/1.01, 0).
    const Vec3 p(-0.01, 0.3, 0.0);
    const auto near = approach<double>(p, flat(), {-0.01, 0.3});
    const double y = 0.3 - 0.3 / 1.01;
    EXPECT_NEAR(near.squared_distance, 1e-4 + y * y, 1e-17);
    EXPECT_EQ(near.side, +1);
    EXPECT_EQ(approach<double>({0.2, 0.2, -1e-300}, flat(), {0.2, 0.2}).side, -1);
    EXPECT_EQ(approach<double>({0.2, 0.2, 0.0}, flat(), {0.2, 0.2}).side, +1);  // on the plane is outward
}

TEST(Centrality, IsZeroAtTheCentroidAndFourThirdsAtACorner) {
    EXPECT_NEAR(centrality<double>({1.0 / 3, 1.0 / 3}), 0.0, 1e-16);
    EXPECT_NEAR(centrality<double>({0.0, 0.0}), 4.0 / 3, 1e-15);
    EXPECT_NEAR(centrality<double>({1.0, 0.0}), 4.0 / 3, 1e-15);
}

TEST(SubTriangle, QuadFansRoundItsMeanAndATriangleStartsAtItsThirdNode) {
    SegmentShape<double> quad;
    quad.node = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 2, 4), Vec3(0, 2, 0)};
    quad.normal = {up, up, Vec3(1, 0, 0), up};
    const auto last = sub_triangle(quad, 4);
    EXPECT_EQ(last.a, Vec3(1, 1, 1));
    EXPECT_EQ(last.normal_a, Vec3(0.25, 0, 0.75));
    EXPECT_EQ(last.b, quad.node[3]);
    EXPECT_EQ(last.c, quad.node[0]);

    SegmentShape<double> triangle;
    triangle.triangle = true;
    triangle.node = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)};
    triangle.normal = {up, up, up, up};
    const auto only = sub_triangle(triangle, 1);
    EXPECT_EQ(only.a, triangle.node[2]);
    EXPECT_EQ(only.b, triangle.node[0]);
    EXPECT_EQ(only.area, Vec3(0, 0, 1));
}

// @manual field DEPTH; comment 4
TEST(Classify, ComparisonsAreStrict) {
    const ContactReach<double> reach{0.5, 2.0, 1.0};
    EXPECT_EQ(classify<double>({0.2499, +1}, reach), Kind::contact);
    EXPECT_EQ(classify<double>({0.25, +1}, reach), Kind::proximity);
    EXPECT_EQ(classify<double>({1.0, +1}, reach), Kind::none);
    EXPECT_EQ(classify<double>({3.99, -1}, reach), Kind::contact);
    EXPECT_EQ(classify<double>({4.0, -1}, reach), Kind::none);
}

TEST(Precedes, ContactThenCentralityThenSegmentThenSubTriangle) {
    Impact<double> a;
    a.kind = Kind::contact;
    a.segment = 7;
    a.triangle = 2;
    a.kappa = 0.9;
    Impact<double> b = a;
    b.kind = Kind::proximity;
    b.kappa = 0.1;
    EXPECT_TRUE(precedes(a, b));
    EXPECT_FALSE(precedes(b, a));
    b = a;
    b.kappa = 0.8;
    EXPECT_TRUE(precedes(b, a));
    b = a;
    b.segment = 6;
    b.triangle = 4;
    EXPECT_TRUE(precedes(b, a));
    b = a;
    b.triangle = 1;
    EXPECT_TRUE(precedes(b, a));
    EXPECT_TRUE(precedes(a, Impact<double>{}));
    EXPECT_FALSE(precedes(Impact<double>{}, Impact<double>{}));
}

}  // namespace
}  // namespace type21::reference
