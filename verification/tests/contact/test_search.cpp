// The tool in its frame, and the claim that the tree of boxes misses nothing.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "reference/as_built/d34_reach_box.h"
#include "reference/contact/candidates.h"
#include "reference/contact/exact_sum.h"
#include "reference/contact/retained_impact.h"
#include "small_scene.h"

namespace type21::reference {
namespace {

// @manual field surf_IDm, IDrby
TEST(ToolSurface, StandsAboutTheCentreOfItsRigidBody) {
    SceneBuilder small = test::over_a_square({{0, 0, 1}});
    small.model().rigid_bodies[0].center = {1, 2, 3};
    const ToolSurface tool(small.model(), small.card());
    ASSERT_EQ(tool.size(), 1);
    EXPECT_EQ(tool.shape(0).node[0], Vec3(-2, -3, -3));
    EXPECT_EQ(tool.shape(0).normal[0], Vec3(0, 0, 1));
}

// @manual field surf_IDm
TEST(NodalNormals, CountSubTrianglesAndNotAreas) {
    // A quad in z = 0 (two sub-triangles at the shared corners, normal z) and a triangle standing up at its edge (one,
    // normal x).
    const std::vector<Vec3> x{{-9, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-9, 1, 0}, {0, 0.5, 1}};
    const auto n = nodal_normals(x, {{0, 1, 2, 3}, {1, 2, 4, 4}});
    EXPECT_NEAR((n[0] - Vec3(0, 0, 1)).norm(), 0, 1e-15);
    // The quad gives 2 z whatever its size, the triangle 1 times (0,1,0) x (0,-0.5,1) = +x.
    EXPECT_NEAR((n[1] - Vec3(1, 0, 2) / std::sqrt(5.0)).norm(), 0, 1e-15);
    EXPECT_NEAR((n[4] - Vec3(1, 0, 0)).norm(), 0, 1e-15);
}

TEST(NodalNormals, ThatCancelAreZeroAndNotNaN) {
    const std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto n = nodal_normals(x, {{0, 1, 2, 2}, {1, 0, 2, 2}});
    for (const Vec3& v : n)
        EXPECT_EQ(v, Vec3(0, 0, 0));
}

// A flat quad and a triangle that stands on its edge: the normal of the edge leans by atan(1/2) = 26.6 degrees. With
// the triangle listed a second time, from the other side even, it stays; where none is noted (D41) it leans by
// atan(2/2).
// @manual field surf_IDm
TEST(ToolSurface, ARepeatedSegmentCountsOnceInTheNormals) {
    const SurfaceMesh tool{{{-9, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-9, 1, 0}, {0, 0.5, 1}},
                           {{0, 1, 2, 3}, {1, 2, 4, 4}, {1, 2, 4, 4}}};
    for (const bool noted : {true, false}) {
        SceneBuilder small = test::small_scene(tool, {{0, 0, 1}});
        if (noted) small.model().surfaces[static_cast<size_t>(small.card().main_surface)].repeated = {2};
        const ToolSurface surface(small.model(), small.card());
        const Vec3 expected = noted ? Vec3(1, 0, 2).normalized() : Vec3(1, 0, 1).normalized();
        EXPECT_NEAR((surface.shape(0).normal[1] - expected).norm(), 0, 1e-15) << noted;
        EXPECT_EQ(surface.size(), 3) << "it stays a segment";
    }
}

/// A bumpy sheet of n x n quads with a fold.
SceneBuilder bumpy(int n) {
    SurfaceMesh sheet = grid(n, n, [n](int i, int j) {
        return Vec3(i, j, 0.6 * std::sin(1.3 * i) * std::cos(0.7 * j) + (i > n / 2 ? 0.8 * (i - n / 2) : 0.0));
    });
    std::vector<std::array<int, 4>> segments;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto& quad = sheet.segment[static_cast<size_t>(j * n + i)];
            if ((i + j) % 3 != 0) {
                segments.push_back(quad);
                continue;
            }
            for (const auto& triangle : split_quads({quad}))
                segments.push_back(triangle);
        }
    sheet.segment = segments;
    return test::small_scene(sheet, {{0, 0, 1}});
}

TEST(Candidates, RetainTheSameImpactAsAllSegments) {
    SceneBuilder small = bumpy(12);
    const ToolSurface tool(small.model(), small.card());
    const ContactReach<double> reach{0.7, 1.4, 0.0};
    const Candidates candidates(tool, 1.4);
    std::vector<int> all(static_cast<size_t>(tool.size()));
    for (int s = 0; s < tool.size(); ++s)
        all[static_cast<size_t>(s)] = s;
    std::mt19937 random(21);
    std::uniform_real_distribution<double> across(-1, 13);
    std::uniform_real_distribution<double> height(-2, 7);
    int in_contact = 0;
    size_t tried = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 p(across(random), across(random), height(random));
        const auto near = candidates.at(p);
        tried += near.size();
        const auto shape = [&](int s) { return tool.shape(s); };
        const auto found = retained_impact<double>(p, near, shape, reach, {});
        const auto expected = retained_impact<double>(p, all, shape, reach, {});
        ASSERT_EQ(found.segment, expected.segment);
        ASSERT_EQ(found.triangle, expected.triangle);
        ASSERT_EQ(found.kind, expected.kind);
        if (expected.kind == Kind::contact) ++in_contact;
        // The order of candidates cannot matter.
        std::shuffle(all.begin(), all.end(), random);
    }
    EXPECT_GT(in_contact, 500);               // the test has positives
    EXPECT_LT(tried, 4000 * all.size() / 4);  // and the tree does skip
}

// @manual departure D34
TEST(ReachBox, GrowsByOnePercentOfItsSize) {
    SegmentShape<double> square;
    square.node = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0)};
    square.normal = {Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1), Vec3(0, 0, 1)};
    const Mat3 axes = Mat3::Identity();
    EXPECT_TRUE(as_built::in_reach_box({1.02, 0, 0}, square, axes, 0.5, 1.0));  // 1 + 0.01 * 2, closed
    EXPECT_FALSE(as_built::in_reach_box({1.0201, 0, 0}, square, axes, 0.5, 1.0));
    EXPECT_TRUE(as_built::in_reach_box({0, 0, 0.515}, square, axes, 0.5, 1.0));  // 0.5 + 0.01 * 1.5
    EXPECT_FALSE(as_built::in_reach_box({0, 0, 0.5151}, square, axes, 0.5, 1.0));
    EXPECT_FALSE(as_built::in_reach_box({0, 0, -1.0151}, square, axes, 0.5, 1.0));
}

TEST(ExactSum, IsRoundedOnceAndKnowsNoOrder) {
    std::vector<double> values{1e16, 1.0, -1e16, 1e-8, 3.0, -1e-8, 1e300, 2.5e-300, -1e300};
    double expected = 4.0;
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        std::shuffle(values.begin(), values.end(), random);
        ExactSum sum;
        for (const double v : values)
            sum.add(v);
        ASSERT_EQ(sum.value(), expected);
    }
    ExactSum half;  // 2^53 + 1 + tiny: a plain sum gives 2^53, the exact one rounds up
    half.add(9007199254740992.0);
    half.add(1.0);
    half.add(1e-20);
    EXPECT_EQ(half.value(), 9007199254740994.0);
    EXPECT_EQ(ExactSum().value(), 0.0);
}

}  // namespace
}  // namespace type21::reference
