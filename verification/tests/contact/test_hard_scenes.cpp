// Hard cases that need motion or size and not geometry: steps longer than the tool is deep, half a turn in one step, a
// tool of a million segments.
#include <cmath>

#include <gtest/gtest.h>

#include "reference/cycle/contact.h"
#include "small_scene.h"

namespace type21::reference {
namespace {

using test::over_a_square;
using test::small_scene;

/// The contact after the given motions of one node and the tool, a cycle each.
struct Cycle {
    Vec3 node = Vec3::Zero();
    Mat3 rotation = Mat3::Identity();
};

NodeContact last_of(const SceneBuilder& scene, const std::vector<Cycle>& cycles) {
    SceneBuilder small = scene;
    Contact contact(small.scene(), 0);
    std::vector<Vec3> position = small.model().nodes.position;
    const std::vector<Vec3> velocity(position.size(), Vec3::Zero());
    NodeContact last;
    double time = 0;
    for (const Cycle& cycle : cycles) {
        position[static_cast<size_t>(small.blank_node(0))] = cycle.node;
        Motion motion;
        motion.time = time;
        motion.step = motion.friction_step = time == 0 ? 0 : 1e-3;
        motion.position = position;
        motion.velocity = velocity;
        motion.tools.emplace_back();
        motion.tools[0].rotation = cycle.rotation;
        last = contact.step(motion).nodes[0];
        time += 1e-3;
    }
    return last;
}

/// n x n unit quads in the plane z = 0 with the first corner at (-n/2, -n/2), numbered row by row.
SceneBuilder unit_grid(int n) {
    return small_scene(grid(n, n, [n](int i, int j) { return Vec3(i - n / 2, j - n / 2, 0); }), {{0, 0, 9}});
}

// g = 0.5, DEPTH = 2 (small_scene). A decision is a function of the state of its cycle: a node that a step carries from
// above the gap to behind DEPTH has passed, and one that lands within DEPTH is behind the tool, in contact.
TEST(HardScenes, a_step_longer_than_depth_passes_through) {
    const SceneBuilder square = over_a_square({{0.2, 0.1, 0.6}});
    const auto from_above_to = [&](double z) { return last_of(square, {{{0.2, 0.1, 0.6}}, {{0.2, 0.1, z}}}); };
    EXPECT_EQ(from_above_to(-2.0).decision.kind, Kind::none);  // d = DEPTH: strict
    EXPECT_EQ(from_above_to(-2.0).force, Vec3::Zero());
    const NodeContact within = from_above_to(std::nextafter(-2.0, 0.0));
    EXPECT_EQ(within.decision.kind, Kind::contact);
    EXPECT_EQ(within.decision.side, -1);
    EXPECT_NEAR(within.geometric_penetration, 2.5, 1e-15);
}

// A half turn about z: (x, y) of the node is seen at (-x, -y). Nothing of the way there matters.
TEST(HardScenes, half_a_turn_in_one_step_is_seen_where_it_ends) {
    const SceneBuilder tool = unit_grid(4);
    Mat3 half_turn = Mat3::Identity();
    half_turn(0, 0) = half_turn(1, 1) = -1;
    const Vec3 node(1.3, 0.4, 0.25);
    // Quad (3, 2) of row 2 spans x 1..2, y 0..1: rank 2 * 4 + 3. The node is 0.2 left of and 0.1 below its centre: in
    // sub-triangle 4, between corners 4 and 1. The opposite point is in quad (0, 1), right of and above its centre: 2.
    const NodeContact before = last_of(tool, {{node}});
    EXPECT_EQ(before.decision.segment, 11);
    EXPECT_EQ(before.decision.triangle, 4);
    const NodeContact after = last_of(tool, {{node}, {node, half_turn}});
    EXPECT_EQ(after.decision.segment, 4);
    EXPECT_EQ(after.decision.triangle, 2);
    const NodeContact at_once = last_of(tool, {{node, half_turn}});
    EXPECT_EQ(after.decision.segment, at_once.decision.segment);
    EXPECT_EQ(after.decision.b, at_once.decision.b);
    EXPECT_EQ(after.decision.c, at_once.decision.c);
    // Half a turn about x brings the other side of the tool to the node: behind it now.
    Mat3 over = Mat3::Identity();
    over(1, 1) = over(2, 2) = -1;
    const NodeContact behind = last_of(tool, {{node}, {node, over}});
    EXPECT_EQ(behind.decision.side, -1);
    EXPECT_NEAR(behind.normal.z(), -1, 1e-15);
}

TEST(HardScenes, a_million_segments) {
    constexpr int n = 1000;
    SceneBuilder tool = unit_grid(n);
    Contact contact(tool.scene(), 0);
    std::vector<Vec3> position = tool.model().nodes.position;
    const std::vector<Vec3> velocity(position.size(), Vec3::Zero());
    Motion motion;
    motion.velocity = velocity;
    motion.tools.emplace_back();
    const auto at = [&](double x, double y) {
        position[static_cast<size_t>(tool.blank_node(0))] = {x, y, 0.25};
        motion.position = position;
        return contact.step(motion).nodes[0].decision;
    };
    // In the first, the last and a middle quad, left of the centre; on the node that four of them share, the lowest.
    const auto rank = [](int i, int j) { return j * n + i; };
    EXPECT_EQ(at(-499.75, -499.5).segment, rank(0, 0));
    EXPECT_EQ(at(499.25, 499.5).segment, rank(n - 1, n - 1));
    EXPECT_EQ(at(-123.75, 321.5).segment, rank(376, 821));
    EXPECT_EQ(at(-123.0, 321.0).segment, rank(376, 820));
    EXPECT_EQ(at(-500.02, 0.5).kind, Kind::none);  // 2 % beyond the border
}

}  // namespace
}  // namespace type21::reference
