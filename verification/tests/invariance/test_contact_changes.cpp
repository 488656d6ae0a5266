// The contact alone, through the seam: rigid motion of everything, order of candidates, steps that others take between.
#include <algorithm>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "reference/contact/retained_impact.h"
#include "reference/contact/tool_surface.h"
#include "reference/cycle/contact.h"
#include "verification/stability/bench_scene.h"

namespace type21 {
namespace {

using namespace stability;

/// Ten nodes that slide over a tool.
std::vector<Vec3> blank(Shape shape) {
    std::vector<Vec3> nodes;
    for (int i = 0; i < 10; ++i)
        nodes.push_back(over(shape, -6.0 + 1.1 * i, -3.0 + 0.7 * i, 0.7));
    return nodes;
}

HostScene scene_of(Shape shape, Mesh mesh) {
    BenchScene bench(make_tool(shape, mesh), blank(shape));
    bench.card().fric.value = 0.2;
    bench.card().viss.value = 0.3;
    return bench.scene();
}

/// A pose of the whole world: x -> turn x + shift.
struct Pose {
    Mat3 turn = Mat3::Identity();
    Vec3 shift = Vec3::Zero();
};

/// All nodes go along the tool and into it, cycle by cycle; forces of all cycles, turned back.
std::vector<Vec3> forces(const HostScene& scene, const Pose& pose, Shape shape, ContactMethod& contact, int from,
                         int to) {
    const auto& secondary = scene.model->interfaces[0].secondary.node;
    std::vector<Vec3> position = scene.model->nodes.position;
    std::vector<Vec3> velocity(position.size(), Vec3::Zero());
    std::vector<Vec3> out;
    constexpr double step = 1e-3;
    constexpr double way = 0.03;  // of a cycle [mm]: slips, and crosses edges
    for (int cycle = from; cycle < to; ++cycle) {
        for (size_t i = 0; i < secondary.size(); ++i) {
            const auto n = static_cast<size_t>(secondary[i]);
            const double s = -6.0 + 1.1 * static_cast<double>(i) + way * cycle;
            const double y = -3.0 + 0.7 * static_cast<double>(i);
            const double d = 0.7 - 0.001 * cycle;
            const Vec3 now = over(shape, s, y, d);
            const Vec3 before = cycle == 0 ? now : over(shape, s - way, y, d + 0.001);
            position[n] = pose.turn * now + pose.shift;
            velocity[n] = pose.turn * ((now - before) / step);
        }
        Motion motion;
        motion.time = cycle * step;
        motion.step = motion.friction_step = cycle == 0 ? 0.0 : step;
        motion.position = position;
        motion.velocity = velocity;
        motion.tools.resize(1);
        motion.tools[0].rotation = pose.turn;
        motion.tools[0].position = pose.shift;
        for (const NodeContact& node : contact.step(motion).nodes)
            out.emplace_back(pose.turn.transpose() * node.force);
    }
    return out;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    EXPECT_EQ(a.size(), b.size());
    double largest = 0;
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, (a[i] - b[i]).norm());
    return largest;
}

constexpr int cycles = 150;

struct Surface {
    Shape shape;
    Mesh mesh;
};

class RigidMotion : public ::testing::TestWithParam<Surface> {};

INSTANTIATE_TEST_SUITE_P(All, RigidMotion,
                         ::testing::Values(Surface{Shape::flat, Mesh::quad}, Surface{Shape::convex, Mesh::distorted},
                                           Surface{Shape::concave, Mesh::triangle},
                                           Surface{Shape::convex, Mesh::warped}));

/// Forces are some 300 N at k = 1000 N/mm. A coordinate of size L is rounded to eps L a few times: k eps L = 2e-13 N
/// per mm of L. Friction adds up 150 cycles at most, and forgets them by slipping.
double rounding(double size) {
    return 100 * 2.2e-16 * stiffness * size;
}

TEST_P(RigidMotion, TurnsTheForcesWithIt) {
    const auto [shape, mesh] = GetParam();
    const HostScene scene = scene_of(shape, mesh);
    reference::Contact still(scene, 0);
    const auto plain = forces(scene, {}, shape, still, 0, cycles);
    double largest = 0;
    for (const Vec3& force : plain)
        largest = std::max(largest, force.norm());
    ASSERT_GT(largest, 100);
    for (const double angle : {0.3, 1.7, 3.1}) {
        Pose pose;
        pose.turn = Eigen::AngleAxisd(angle, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
        pose.shift = Vec3(30, -70, 110);
        reference::Contact turned(scene, 0);
        EXPECT_LT(largest_difference(plain, forces(scene, pose, shape, turned, 0, cycles)), rounding(150)) << angle;
    }
}

// y = R^T (x - x_G) is exact when the sum was: then every bit of the contact is the same.
TEST_P(RigidMotion, ByAPowerOfTwoOfNodesOnAGridKeepsEveryBitOfTheDecisions) {
    const auto [shape, mesh] = GetParam();
    const HostScene scene = scene_of(shape, mesh);
    std::vector<Vec3> position = scene.model->nodes.position;
    const auto on_grid = [](const Vec3& x) { return Vec3(((x * 16777216.0).array().round() / 16777216.0).matrix()); };
    const std::vector<Vec3> velocity(position.size(), Vec3::Zero());
    const auto step = [&](const Vec3& shift) {
        std::vector<Vec3> there;
        for (const Vec3& x : position)
            there.emplace_back(on_grid(x) + shift);
        Motion motion;
        motion.position = there;
        motion.velocity = velocity;
        motion.tools.resize(1);
        motion.tools[0].position = shift;
        return reference::Contact(scene, 0).step(motion);
    };
    const ContactStep here = step(Vec3::Zero());
    const ContactStep there = step(Vec3(1024, -65536, 4096));
    int contacts = 0;
    for (size_t i = 0; i < here.nodes.size(); ++i) {
        contacts += here.nodes[i].decision.kind == Kind::contact ? 1 : 0;
        EXPECT_EQ(here.nodes[i].decision.segment, there.nodes[i].decision.segment);
        EXPECT_EQ(here.nodes[i].decision.b, there.nodes[i].decision.b);
        EXPECT_EQ(here.nodes[i].decision.c, there.nodes[i].decision.c);
        EXPECT_EQ(here.nodes[i].force, there.nodes[i].force);
    }
    EXPECT_GT(contacts, 5);
}

// The seam is the only way in: a contact whose cycles are interrupted by others', and by questions about time 0, goes
// on as if nothing had been.
TEST_P(RigidMotion, AnInterruptedContactGoesOnWithTheSameBits) {
    const auto [shape, mesh] = GetParam();
    const HostScene scene = scene_of(shape, mesh);
    reference::Contact whole(scene, 0);
    const auto expected = forces(scene, {}, shape, whole, 0, cycles);
    reference::Contact parts(scene, 0);
    auto got = forces(scene, {}, shape, parts, 0, cycles / 2);
    reference::Contact other(scene, 0);
    forces(scene, {}, shape, other, 0, 20);
    parts.initial_penetrations(scene.model->nodes.position);
    const auto rest = forces(scene, {}, shape, parts, cycles / 2, cycles);
    got.insert(got.end(), rest.begin(), rest.end());
    EXPECT_EQ(got, expected);
}

// By design: over the common edge of two segments both take the node equally well, and the lowest number wins.
TEST(Ties, GoToAnotherSegmentWhenTheSegmentsAreRenumbered) {
    Tool tool = make_tool(Shape::flat, Mesh::quad);
    const Vec3 over_edge(0, 0.9, 0.7);  // between columns 4 and 5 of row 5
    const MakeContact make = [](const Scene& s, int i) { return std::make_unique<reference::Contact>(s, i); };
    const NodeContact first =
        PrescribedNode(BenchScene(tool, {over_edge}).scene(), make).to(over_edge, Vec3::Zero(), 0);
    std::reverse(tool.segment.begin(), tool.segment.end());
    const NodeContact second =
        PrescribedNode(BenchScene(tool, {over_edge}).scene(), make).to(over_edge, Vec3::Zero(), 0);
    EXPECT_EQ(first.decision.segment, 54);
    EXPECT_EQ(second.decision.segment, 99 - 55) << "the same rule, the other piece";
    EXPECT_EQ(first.force, second.force) << "on one plane both give the same force";
    EXPECT_NEAR(first.normal_force, 300, 1e-12);
}

TEST(Candidates, InAnyOrderGiveTheSameBits) {
    for (const Mesh mesh : {Mesh::quad, Mesh::triangle, Mesh::distorted, Mesh::warped}) {
        const HostScene scene = scene_of(Shape::concave, mesh);
        const reference::ToolSurface tool(*scene.host, scene.model->interfaces[0]);
        std::vector<int> order(static_cast<size_t>(tool.size()));
        for (size_t s = 0; s < order.size(); ++s)
            order[s] = static_cast<int>(s);
        const std::vector<int> ascending = order;
        const auto shape = [&](int s) { return tool.shape(s); };
        const reference::ContactReach<double> reach{gap, depth, 1.5};
        std::mt19937 random(4);
        int contacts = 0;
        for (int i = 0; i < 300; ++i) {
            // Half of them over nodes and edges, where several segments take the node equally well.
            const double s = i % 2 == 0 ? 0.1 * (i % 60) - 3 : 2.0 * (i % 5) - 4;
            const Vec3 p = over(Shape::concave, s, i % 4 == 1 ? 0.0 : 0.05 * (i % 37), 0.01 * (i % 120));
            const auto first = reference::retained_impact<double>(p, ascending, shape, reach, {});
            std::shuffle(order.begin(), order.end(), random);
            const auto second = reference::retained_impact<double>(p, order, shape, reach, {});
            ASSERT_EQ(first.kind, second.kind);
            contacts += first.kind == Kind::contact ? 1 : 0;
            if (first.kind == Kind::none) continue;
            EXPECT_EQ(first.segment, second.segment);
            EXPECT_EQ(first.triangle, second.triangle);
            EXPECT_EQ(first.projection.weights.b, second.projection.weights.b);
            EXPECT_EQ(first.projection.weights.c, second.projection.weights.c);
            EXPECT_EQ(first.kappa, second.kappa);
        }
        EXPECT_GT(contacts, 100);
    }
}

}  // namespace
}  // namespace type21
