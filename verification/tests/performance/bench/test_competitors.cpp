// Those that the bench compares with give right answers where these are known.
#include <algorithm>
#include <cmath>
#include <malloc.h>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "reference/contact/tool_surface.h"
#include "verification/performance/bench/bare_step.h"
#include "verification/performance/bench/candidate_list.h"
#include "verification/performance/bench/contact_run.h"
#include "verification/performance/bench/exact_decisions.h"
#include "verification/performance/bench/full_search.h"
#include "verification/performance/bench/plain_search.h"

namespace type21::bench {
namespace {

SurfaceMesh mesh_of(const BenchScene& scene) {
    const optimized::Tool tool(*scene.scene.host, scene.card());
    SurfaceMesh mesh;
    for (int s = 0; s < tool.size(); ++s)
        mesh.segment.push_back(tool.corner(s));
    for (const int node : scene.card().main_nodes)
        mesh.node.push_back(scene.scene.model->nodes.position[static_cast<size_t>(node)]);
    return mesh;
}

std::vector<Vec3> nodes_of(const BenchScene& scene) {
    std::vector<Vec3> out;
    for (const int node : scene.card().secondary.node)
        out.push_back(scene.scene.model->nodes.position[static_cast<size_t>(node)]);
    return out;
}

std::vector<BenchScene> small_scenes() {
    std::vector<BenchScene> all;
    all.push_back(bowl_bench(24, 16));
    all.push_back(pan_bench("pan", 2000, 1500));
    all.push_back(ties_bench(8));
    return all;
}

TEST(DistanceToTriangle, IsThatOfFaceEdgeAndCorner) {
    const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
    EXPECT_DOUBLE_EQ(distance2_to_triangle({1, 1, 3}, a, b, c), 9);
    EXPECT_DOUBLE_EQ(distance2_to_triangle({2, -3, 0}, a, b, c), 9);
    EXPECT_DOUBLE_EQ(distance2_to_triangle({-3, -4, 0}, a, b, c), 25);
    EXPECT_DOUBLE_EQ(distance2_to_triangle({4, 4, 1}, a, b, c), 9);
    EXPECT_DOUBLE_EQ(distance2_to_triangle({7, 4, 0}, a, b, a), 25) << "a triangle without area is its edges";
}

bool allocator_tells() {
    return mallinfo2().uordblks > 0;
}

TEST(ClosestPoint, EachFindsTheNearest) {
    for (const BenchScene& scene : small_scenes()) {
        const SurfaceMesh mesh = mesh_of(scene);
        const auto truth = closest_by_force(mesh);
        const double reach = 1.05 * scene.card().largest_gap;
        const auto embree = has_embree() ? closest_by_embree(mesh, reach) : nullptr;
        const auto cgal = closest_by_cgal_double(mesh), epick = closest_by_cgal_epick(mesh);
        int within = 0;
        for (const Vec3& p : nodes_of(scene)) {
            const double expected = std::sqrt(truth->at(p).distance2);
            if (expected > reach) continue;
            ++within;
            for (const ClosestPoint* method : {embree.get(), cgal.get(), epick.get()}) {
                if (method == nullptr) continue;
                const Nearest found = method->at(p);
                ASSERT_NEAR(std::sqrt(found.distance2), expected, 1e-12 * (1 + p.norm())) << scene.name;
                ASSERT_GE(found.segment, 0);
            }
        }
        EXPECT_GT(within, 200) << scene.name;
        if (embree) {
            EXPECT_GT(embree->bytes(), 0U);
        }
        // The allocator of the sanitizers does not tell what is in use.
        if (allocator_tells()) {
            EXPECT_GT(cgal->bytes(), 0U);
        }
    }
}

TEST(ClosestPoint, EmbreeSaysNothingBeyondItsReach) {
    if (!has_embree()) GTEST_SKIP() << "built without Embree";
    const BenchScene scene = bowl_bench(8, 8);
    const auto embree = closest_by_embree(mesh_of(scene), 0.5);
    EXPECT_EQ(embree->at({0, 0, -30}).segment, -1);
}

TEST(CandidateSort, FindsAllPairsThatAreNear) {
    for (const BenchScene& scene : small_scenes()) {
        const SurfaceMesh mesh = mesh_of(scene);
        const std::vector<Vec3> y = nodes_of(scene);
        const Interface& card = scene.card();
        const SortSizes sizes = sort_sizes(card.largest_gap, card.depth, card.shortest_edge);
        std::set<std::pair<int, int>> found;
        for (const CandidatePair& pair : sorted_pairs(mesh, y, sizes))
            EXPECT_TRUE(found.insert({pair.node, pair.segment}).second) << "a pair came twice";
        size_t near = 0;
        const double limit = std::max(sizes.gap, sizes.depth) + sizes.margin;
        for (size_t i = 0; i < y.size(); ++i) {
            for (size_t s = 0; s < mesh.segment.size(); ++s) {
                const SurfaceMesh one{mesh.node, {mesh.segment[s]}};
                if (!(closest_by_force(one)->at(y[i]).distance2 < limit * limit)) continue;
                ++near;
                ASSERT_TRUE(found.count({static_cast<int>(i), static_cast<int>(s)}))
                    << scene.name << " " << i << " " << s;
            }
            if (scene.name == "pan" && i == 100) break;  // one node against all segments takes a while
        }
        EXPECT_GT(near, 100U);
    }
}

TEST(CandidateSort, SizesAreThoseOfTheEngine) {
    const SortSizes sizes = sort_sizes(0.5, 0.5, 0.35);
    EXPECT_DOUBLE_EQ(sizes.margin, 0.2 * 1.251 * 0.5);
    EXPECT_DOUBLE_EQ(sizes.reach, sizes.margin + 0.5);
    EXPECT_DOUBLE_EQ(sizes.smallest_box, 0.25 * (1.251 * 0.5 + 2 * sizes.reach));
    EXPECT_DOUBLE_EQ(sort_sizes(0.5, 0.5, 3).margin, 0.6) << "the mean edge where it is larger";
}

TEST(CandidateList, DecidesAndPushesAsTheContactDoesBesideTies) {
    // The pan is irregular: rounding decides nothing there. 60 cycles of 2 um in which it sorts once.
    const BenchScene scene = pan_bench("pan", 2000, 1500);
    const SurfaceMesh mesh = mesh_of(scene);
    CandidateList list(mesh, reference::nodal_normals(mesh.node, mesh.segment), scene.card(),
                       scene.card().shortest_edge);
    optimized::Contact contact(scene.scene, 0);
    for (int c = 0; c < 60; ++c) {
        const Motion motion = scene.motion(c);
        list.step(motion);
        const ContactStep step = contact.step(motion);
        double most = 0, apart = 0;
        for (size_t i = 0; i < step.nodes.size(); ++i) {
            const Decision& d = step.nodes[i].decision;
            ASSERT_EQ(list.retained()[i].segment, d.segment) << c << " " << i;
            if (d.segment < 0) continue;
            ASSERT_EQ(list.retained()[i].triangle, d.triangle);
            most = std::max(most, step.nodes[i].force.norm());
            apart = std::max(apart, (step.nodes[i].force - list.force()[i]).norm());
        }
        EXPECT_GT(most, 1);
        EXPECT_LT(apart, 1e-6 * most) << "in cycle " << c << "; the direction of P - X is rounded near the surface";
        EXPECT_LT((list.tool_force() - step.tool.force).norm(), 1e-6 * step.tool.force.norm());
    }
    EXPECT_EQ(list.sorts(), 1);
}

TEST(CandidateList, SortsAgainWhenSomethingHasMovedByTheMargin) {
    const BenchScene scene = bowl_bench(24, 16);
    const SurfaceMesh mesh = mesh_of(scene);
    CandidateList list(mesh, reference::nodal_normals(mesh.node, mesh.segment), scene.card(), 0.35);
    const int last = static_cast<int>(list.sizes().margin / scene.step_length);
    list.step(scene.motion(0));
    list.step(scene.motion(last));
    EXPECT_EQ(list.sorts(), 1);
    list.step(scene.motion(last + 2));
    EXPECT_EQ(list.sorts(), 2);
}

TEST(PlainSearch, IsRightBesideTies) {
    const BenchScene scene = pan_bench("pan", 2000, 1500);
    const auto laws = laws_with_search(scene.scene, 0);
    const std::vector<Decision> truth = ExactDecisions(scene).at(scene.motion(0));
    std::vector<optimized::V3> y;
    for (const Vec3& node : nodes_of(scene))
        y.push_back(optimized::from(node));
    const std::vector<double> gap(y.size(), 2);
    std::vector<Decision> plain(y.size()), exact(y.size());
    PlainSearch(laws->tool, laws->search->limits()).at(y, gap, 2, plain);
    FullSearch full(*laws);
    full.at(y, gap, exact);
    for (size_t i = 0; i < y.size(); ++i) {
        EXPECT_TRUE(same(plain[i], truth[i])) << i;
        EXPECT_TRUE(same(exact[i], truth[i])) << i;
    }
    EXPECT_EQ(std::accumulate(full.settled().begin(), full.settled().end(), 0L), static_cast<long>(y.size()));
}

TEST(BareStep, GivesTheVeryForcesOfTheProduct) {
    for (const BenchScene& scene : small_scenes()) {
        BareStep bare(scene, true);
        optimized::Contact contact(scene.scene, 0);
        for (int c = 0; c < 5; ++c) {
            const Motion motion = scene.motion(c);
            bare.step(motion);
            const ContactStep step = contact.step(motion);
            for (size_t i = 0; i < step.nodes.size(); ++i)
                ASSERT_EQ(bare.force()[i], step.nodes[i].force) << scene.name << " " << c << " " << i;
            EXPECT_EQ(bare.tool_force(), step.tool.force);
        }
        bare.step(scene.motion(5), BareStep::Until::sum, BareStep::Sums::plain);
        const ContactStep step = contact.step(scene.motion(5));
        EXPECT_LT((bare.tool_force() - step.tool.force).norm(), 1e-9 * step.tool.force.norm());
    }
}

}  // namespace
}  // namespace type21::bench
