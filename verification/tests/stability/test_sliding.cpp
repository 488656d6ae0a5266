// The force along a path: what must be continuous is, and facets are not.
#include <memory>

#include <gtest/gtest.h>

#include "reference/cycle/contact.h"
#include "verification/stability/facet_contact.h"
#include "verification/stability/stability_report.h"

namespace type21::stability {
namespace {

const MakeContact make_reference = [](const Scene& scene, int i) {
    return std::make_unique<reference::Contact>(scene, i);
};

/// Rounding of k = 1000 N/mm times a position of 10 mm: 1e4 N x 1e-16, some operations long [N].
constexpr double rounding = 1e-11;

TEST(Sliding, OnAPlaneNothingJumpsWhateverTheMesh) {
    for (const Mesh mesh : {Mesh::quad, Mesh::triangle, Mesh::distorted}) {
        const SlidingRow row = slide_over(make_reference, Shape::flat, mesh);
        EXPECT_EQ(row.open, 0);
        EXPECT_NEAR(row.mean_force, 300, 1e-9);  // k x 0.3 mm
        for (size_t i = 0; i < path_steps; ++i) {
            EXPECT_LE(row.normal.largest[i], rounding) << name(mesh);
            EXPECT_LE(row.friction.largest[i], rounding) << name(mesh);
        }
    }
}

TEST(Sliding, OnCylindersOfQuadsAndTrianglesAllOfTheJumpHalves) {
    for (const Shape shape : {Shape::convex, Shape::concave}) {
        for (const Mesh mesh : {Mesh::quad, Mesh::triangle}) {
            const SlidingRow row = slide_over(make_reference, shape, mesh);
            EXPECT_EQ(row.open, 0);
            // The force is smooth in the way: J(h/2) / J(h) is 1/2 but for terms of the order of h / element = 1e-2.
            for (size_t i = 1; i < path_steps; ++i)
                EXPECT_NEAR(row.normal.largest[i] / row.normal.largest[i - 1], 0.5, 0.01) << name(shape) << name(mesh);
            EXPECT_TRUE(holds(row)) << to_text(std::vector{row});
        }
    }
}

/// Two facets of a cylinder of 20 segments in 20 / 10 rad meet at 0.2 rad: |F| 2 sin(0.1) = 0.2 |F|.
TEST(Sliding, FacetsJumpByTheAngleBetweenThem) {
    for (const Shape shape : {Shape::convex, Shape::concave}) {
        const SlidingRow row = slide_over(make_reference, shape, Mesh::quad);
        EXPECT_NEAR(row.facet_normal.residual(), 0.2 * 300, 0.1 * 60);
        for (const double jump : row.facet_normal.largest)
            EXPECT_NEAR(jump, row.facet_normal.residual(), 0.05 * 60) << "it does not halve";
    }
}

TEST(Sliding, OnDistortedAndWarpedMeshesTheMethodJumpsMuchLessThanFacets) {
    for (const Shape shape : {Shape::convex, Shape::concave}) {
        for (const Mesh mesh : {Mesh::distorted, Mesh::warped}) {
            const SlidingRow row = slide_over(make_reference, shape, mesh);
            EXPECT_TRUE(holds(row)) << to_text(std::vector{row});
            EXPECT_GT(row.normal.residual(), 1e-3) << "the method has a jump of its own here; its size is shown";
        }
    }
}

TEST(Sliding, ARowThatJumpsAsFacetsDoDoesNotHold) {
    SlidingRow row = slide_over(make_reference, Shape::convex, Mesh::warped);
    ASSERT_TRUE(holds(row));
    SlidingRow normal = row;
    normal.normal = row.facet_normal;
    EXPECT_FALSE(holds(normal));
    SlidingRow friction = row;
    friction.friction = row.facet_friction;
    EXPECT_FALSE(holds(friction));
    row.open = 1;
    EXPECT_FALSE(holds(row));
}

TEST(Facets, NearestPointOfATriangle) {
    const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 3, 0);
    EXPECT_EQ(nearest_point({1, 1, 2}, a, b, c), Vec3(1, 1, 0));    // inside
    EXPECT_EQ(nearest_point({2, -1, 1}, a, b, c), Vec3(2, 0, 0));   // an edge
    EXPECT_EQ(nearest_point({-1, -1, 1}, a, b, c), Vec3(0, 0, 0));  // a corner
    // Beyond the long edge 3 x + 4 y = 12: (2, 1.5) + t (3, 4) comes back to (2, 1.5).
    EXPECT_NEAR((nearest_point({5, 5.5, 0}, a, b, c) - Vec3(2, 1.5, 0)).norm(), 0, 1e-15);
}

TEST(Facets, ForceOfAPlaneByHand) {
    const FacetContact facets(make_tool(Shape::flat, Mesh::quad));
    const FacetForce force = facets.at({0.3, 0.4, 0.75}, {0, 2, 1}, 0.2);
    EXPECT_NEAR((force.normal - Vec3(0, 0, 250)).norm(), 0, 1e-12);  // 1000 N/mm x 0.25 mm
    EXPECT_NEAR((force.friction - Vec3(0, 50, 0)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace type21::stability
