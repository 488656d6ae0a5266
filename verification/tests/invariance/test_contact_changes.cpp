// The contact through its contract only: rigid motion of everything, order of candidates, steps of other contacts
// between.
#include <algorithm>
#include <memory>
#include <random>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/contact/retained_impact.h"
#include "reference/contact/tool_surface.h"
#include "verification/stability/long_run_scene.h"
#include "verification/support/contact_choice.h"
#include "verification/support/prescribed_motion.h"

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
    return long_run_scene(make_tool(shape, mesh), blank(shape)).fric(0.2).viss(0.3).scene();
}

/// A rigid motion of blank and tool together: x -> turn x + shift.
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

/// Both implementations keep these bits, and forces to the same rounding.
class RigidMotion : public ::testing::TestWithParam<std::tuple<std::string, Surface>> {
  protected:
    const Surface surface_ = std::get<Surface>(GetParam());
    const HostScene scene_ = scene_of(surface_.shape, surface_.mesh);

    std::unique_ptr<ContactMethod> contact() const {
        return contact_maker(std::get<std::string>(GetParam()))(scene_, 0);
    }
};

INSTANTIATE_TEST_SUITE_P(All, RigidMotion,
                         ::testing::Combine(::testing::ValuesIn(contact_choices()),
                                            ::testing::Values(Surface{Shape::flat, Mesh::quad},
                                                              Surface{Shape::convex, Mesh::distorted},
                                                              Surface{Shape::concave, Mesh::triangle},
                                                              Surface{Shape::convex, Mesh::warped})),
                         [](const auto& tested) {
                             const Surface& surface = std::get<1>(tested.param);
                             return fmt::format("{}_{}_{}", std::get<0>(tested.param), name(surface.shape),
                                                name(surface.mesh));
                         });

/// Forces are some 300 N at k = 1000 N/mm. A coordinate of size L is rounded to eps L a few times: k eps L = 2e-13 N
/// per mm of L. Friction adds up 150 cycles at most, and forgets them by slipping.
double rounding(double size) {
    return 100 * 2.2e-16 * stiffness * size;
}

TEST_P(RigidMotion, TurnsTheForcesWithIt) {
    const auto plain = forces(scene_, {}, surface_.shape, *contact(), 0, cycles);
    double largest = 0;
    for (const Vec3& force : plain)
        largest = std::max(largest, force.norm());
    ASSERT_GT(largest, 100);
    for (const double angle : {0.3, 1.7, 3.1}) {
        Pose pose;
        pose.turn = Eigen::AngleAxisd(angle, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
        pose.shift = Vec3(30, -70, 110);
        const auto turned = forces(scene_, pose, surface_.shape, *contact(), 0, cycles);
        EXPECT_LT(largest_difference(plain, turned), rounding(150)) << angle;
    }
}

// y = R^T (x - x_G) is exact when the sum was: then every bit of the contact is the same.
TEST_P(RigidMotion, ByAPowerOfTwoOfNodesOnAGridKeepsEveryBitOfTheDecisions) {
    const std::vector<Vec3>& position = scene_.model->nodes.position;
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
        return contact()->step(motion);
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

// A contact has no state outside its object: when other contacts step between its cycles, or initial_penetrations() is
// called, it goes on with the same bits.
TEST_P(RigidMotion, AnInterruptedContactGoesOnWithTheSameBits) {
    const Shape shape = surface_.shape;
    const auto expected = forces(scene_, {}, shape, *contact(), 0, cycles);
    const auto parts = contact();
    auto got = forces(scene_, {}, shape, *parts, 0, cycles / 2);
    forces(scene_, {}, shape, *contact(), 0, 20);
    parts->initial_penetrations(scene_.model->nodes.position);
    const auto rest = forces(scene_, {}, shape, *parts, cycles / 2, cycles);
    got.insert(got.end(), rest.begin(), rest.end());
    EXPECT_EQ(got, expected);
}

// By design: over the common edge of two segments both have the same kappa, and the lower segment is retained.
class Ties : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(By, Ties, ::testing::ValuesIn(contact_choices()),
                         [](const auto& tested) { return tested.param; });

TEST_P(Ties, GoToAnotherSegmentWhenTheSegmentsAreRenumbered) {
    SurfaceMesh tool = make_tool(Shape::flat, Mesh::quad);
    const Vec3 over_edge(0, 0.9, 0.7);  // between columns 4 and 5 of row 5
    const MakeContact make = contact_maker(GetParam());
    const NodeContact first =
        PrescribedNode(long_run_scene(tool, {over_edge}).scene(), make).to(over_edge, Vec3::Zero(), 0);
    std::reverse(tool.segment.begin(), tool.segment.end());
    const NodeContact second =
        PrescribedNode(long_run_scene(tool, {over_edge}).scene(), make).to(over_edge, Vec3::Zero(), 0);
    EXPECT_EQ(first.decision.segment, 54);
    EXPECT_EQ(second.decision.segment, 99 - 55) << "the same rule, the other segment";
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
