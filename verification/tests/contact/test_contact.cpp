// One interface through a few cycles, every number by hand: nodes over one square, k = 1000, m = 1, g = 0.5, DEPTH = 2.
#include <cmath>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/contract/make_contact.h"
#include "reference/cycle/contact.h"
#include "small_scene.h"

namespace type21::reference {
namespace {

using test::over_a_square;

/// Positions and velocities of a SceneBuilder that a test moves by hand.
struct Hand {
    explicit Hand(SceneBuilder& scene)
        : small(scene), position(scene.model().nodes.position), velocity(position.size(), Vec3::Zero()) {
        contact = std::make_unique<Contact>(scene.scene(), 0);
        tools.emplace_back();
    }
    ContactStep step(double time, double dt) {
        Motion motion;
        motion.time = time;
        motion.step = motion.friction_step = dt;
        motion.position = position;
        motion.velocity = velocity;
        motion.tools = tools;
        return contact->step(motion);
    }
    Vec3& x(int i) { return position[static_cast<size_t>(small.blank_node(i))]; }
    Vec3& v(int i) { return velocity[static_cast<size_t>(small.blank_node(i))]; }

    SceneBuilder& small;
    std::vector<Vec3> position;
    std::vector<Vec3> velocity;
    std::vector<ToolMotion> tools;
    std::unique_ptr<Contact> contact;
};

TEST(Contact, FullElasticForceAtTimeZero) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}, {0.2, 0.1, 0.6}});
    Hand hand(small);
    const ContactStep step = hand.step(0, 0);
    EXPECT_NEAR(step.nodes[0].force.z(), 200, 1e-10);  // k (g - 0.3)
    EXPECT_EQ(step.nodes[1].decision.kind, Kind::none);
    EXPECT_NEAR(step.sums.normal.z(), -200, 1e-10);  // on the tool
    EXPECT_NEAR(step.sums.signed_normal, -200, 1e-10);
    EXPECT_NEAR(step.sums.elastic_energy, 20, 1e-11);      // k p^2 / 2
    EXPECT_NEAR(step.tool.moment.x(), 0.1 * -200, 1e-10);  // (X - x_G) x F = (0.2, 0.1, 0) x (0, 0, -200)
    EXPECT_NEAR(step.tool.moment.y(), 0.2 * 200, 1e-10);
}

// @manual field Inacti; comment 9
TEST(Contact, InactiStartsWithAnOffset) {
    for (const int inacti : {1, 5, 6}) {
        SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
        small.card().inacti.value = inacti;
        Hand hand(small);
        const ContactStep step = hand.step(0, 0);
        EXPECT_EQ(step.nodes[0].force, Vec3(0, 0, 0)) << inacti;
        hand.x(0).z() = 0.25;  // deeper by 0.05 in one cycle
        const ContactStep next = hand.step(1e-3, 1e-3);
        // 1: off for good. 5: P0 stays 0.2. 6: P0 = 0.2 + 0.05 (0.5 + 2 - 0.2) = 0.315, then twice relaxed; still above
        // 0.25.
        EXPECT_NEAR(next.nodes[0].force.z(), inacti == 5 ? 50 : 0, 1e-10) << inacti;
        if (inacti == 6) {
            const double first = 0.95 * 0.315 + 0.05 * (0.2 + 0.05 * 0.3);
            EXPECT_NEAR(next.nodes[0].offset, 0.95 * first + 0.05 * (0.25 + 0.05 * 0.25), 1e-15);
        }
    }
}

// @manual field VISs; comment 9
TEST(Contact, FirstCycleOfALaterImpactHasDampingOnly) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.6}});
    small.card().viss.value = 0.5;
    Hand hand(small);
    hand.step(0, 0);
    hand.x(0).z() = 0.4;
    hand.v(0).z() = -2;
    const ContactStep hit = hand.step(0.1, 0.1);
    const double c = 0.5 * std::sqrt(2.0 * 1000 * 1);
    EXPECT_EQ(hit.nodes[0].elastic_force, 0.0);
    EXPECT_NEAR(hit.nodes[0].force.z(), 2 * c, 1e-12);
    EXPECT_NEAR(hit.nodes[0].step_stiffness, 1000 + c / 0.1, 1e-10);
    EXPECT_NEAR(hit.sums.damping_work, c * 4 * 0.1, 1e-12);
    hand.x(0).z() = 0.3;
    const ContactStep second = hand.step(0.2, 0.1);
    EXPECT_NEAR(second.nodes[0].elastic_force, 100, 1e-10);  // p = 0.2 - 0.1
    hand.x(0).z() = 0.55;                                    // leaves: everything is forgotten
    hand.step(0.3, 0.1);
    hand.x(0).z() = 0.45;
    EXPECT_EQ(hand.step(0.4, 0.1).nodes[0].elastic_force, 0.0);
}

// @manual field VISs
TEST(Contact, DampingPullsWhenTheNodeLeaves) {
    SceneBuilder small = over_a_square({{0, 0, 0.49}});
    small.card().viss.value = 1.0;
    Hand hand(small);
    hand.v(0).z() = 3;
    EXPECT_NEAR(hand.step(0, 0).nodes[0].normal_force, 1000 * 0.01 - std::sqrt(2000.0) * 3, 1e-10);
}

// @manual eq 12; field Fric; comment 12, 14
TEST(Contact, CoulombFrictionBuildsUpAndSlips) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.4}});
    small.card().fric.value = 0.1;
    Hand hand(small);
    hand.v(0).x() = 0.02;
    hand.step(0, 0);
    const ContactStep stick = hand.step(0.1, 0.1);  // k v dt = 1000 * 0.02 * 0.1 = 2 < mu F = 0.1 * 100
    EXPECT_NEAR(stick.nodes[0].friction.x(), 2, 1e-12);
    EXPECT_EQ(stick.nodes[0].status, Status::stick);
    EXPECT_NEAR(stick.sums.friction_work, 0.02 * 2 * 0.1, 1e-14);
    hand.v(0).x() = 1;
    const ContactStep slip = hand.step(0.2, 0.1);
    EXPECT_NEAR(slip.nodes[0].friction.x(), 10, 1e-12);
    EXPECT_EQ(slip.nodes[0].status, Status::slip);
    EXPECT_NEAR(slip.nodes[0].force.x(), -10, 1e-12);  // on the node, against its motion
    EXPECT_NEAR(slip.sums.tangential.x(), 10, 1e-12);  // on the tool
}

TEST(Contact, TheVelocityOfATurningToolIsTakenAtTheContactPoint) {
    SceneBuilder small = over_a_square({{0.5, 0, 0.4}});
    small.card().viss.value = 1.0;
    Hand hand(small);
    hand.tools[0].velocity = {0, 0, 1};
    hand.tools[0].angular_velocity = {0, -2, 0};  // at X = (0.5, 0, 0): (0, -2, 0) x (0.5, 0, 0) = (0, 0, 1)
    const ContactStep step = hand.step(0, 0);
    EXPECT_NEAR(step.nodes[0].relative_velocity.z(), -2, 1e-15);
}

TEST(Contact, ATurnedToolTurnsTheForce) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    Hand hand(small);
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const Vec3 shift(4, 5, 6);
    hand.tools[0].rotation = turn;
    hand.tools[0].position = shift;
    hand.x(0) = shift + turn * Vec3(0.2, 0.1, 0.3);
    const ContactStep step = hand.step(0, 0);
    EXPECT_NEAR((step.nodes[0].force - turn * Vec3(0, 0, 200)).norm(), 0, 1e-9);
}

// @manual field DEPTH, Tstart, Tstop; comment 4, 20
TEST(Contact, NoForceDeeperThanDepthOrOutsideTheWindow) {
    SceneBuilder small = over_a_square({{0.2, 0.1, -1.99}, {0.2, 0.1, -2.0}});
    Hand hand(small);
    const ContactStep step = hand.step(0, 0);
    EXPECT_NEAR(step.nodes[0].force.z(), 2490, 1e-9);
    EXPECT_EQ(step.nodes[1].force, Vec3(0, 0, 0));
    SceneBuilder late = over_a_square({{0.2, 0.1, 0.3}});
    late.card().tstart.value = 0.5;
    Hand wait(late);
    EXPECT_FALSE(wait.step(0.4, 0.1).active);
    EXPECT_TRUE(wait.step(0.5, 0.1).active);
}

// @manual field Invn; comment 21
TEST(Contact, InvnNamesTheNodeThatCameFromBehind) {
    SceneBuilder small = over_a_square({{0.2, 0.1, -1.99}, {0.2, 0.1, -1.9}});
    small.card().invn.value = 1;
    Hand hand(small);
    const ContactStep step = hand.step(0, 0);
    ASSERT_EQ(step.inverted.size(), 1u);  // p_g > 0.5 + 0.99 * 2 = 2.48: 2.49 is, 2.40 is not
    EXPECT_EQ(step.inverted[0].node, small.blank_node(0));
}

// @manual field IBC; comment 7
TEST(Contact, IbcReleasesOnceAtTheFirstEffectivePenetration) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.6}});
    small.card().ibc.value = 1;
    Hand hand(small);
    hand.step(0, 0);
    hand.x(0).z() = 0.45;
    EXPECT_TRUE(hand.step(0.1, 0.1).released.empty());  // first cycle: p = 0
    hand.x(0).z() = 0.44;
    EXPECT_EQ(hand.step(0.2, 0.1).released, std::vector<int>{small.blank_node(0)});
    EXPECT_TRUE(hand.step(0.3, 0.1).released.empty());
}

// @manual field Damp, IDref; comment 19; departure D13
TEST(Contact, ToolDampingUsesTheContactStiffness) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}, {-0.2, 0.1, 0.3}});
    small.card().damp.value = 0.1;
    small.card().viss.value = 1.0;
    Hand hand(small);
    hand.tools[0].velocity = {0, 0, -2};
    hand.step(0, 0);
    const double c = 2 * 0.1 * std::sqrt(10 * 2000.0);  // M = 10, sum of k = 2000
    EXPECT_NEAR(hand.step(0.1, 0.1).tool.damping_force.z(), 2 * c, 1e-10);

    small.model().as_built.set(Departure::D13);
    Hand built(small);
    built.tools[0].velocity = {0, 0, -2};
    built.step(0, 0);
    const double k = 2 * (1000 + std::sqrt(2000.0) / 0.1);
    EXPECT_NEAR(built.step(0.1, 0.1).tool.damping_force.z(), 2 * 2 * 0.1 * std::sqrt(10 * k), 1e-9);
}

// Two nodes with k = 1000 at (+-0.2, 0.1, 0) from x_G: the sum of k |X - x_G|^2 is 2 * 1000 * 0.05 = 100. I = 5.
// @manual field Dampr; comment 19; departure D13
TEST(Contact, DamprBrakesTheTurnAboutEachAxis) {
    for (const bool d13 : {false, true}) {
        for (int axis = 0; axis < 3; ++axis) {
            SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}, {-0.2, 0.1, 0.3}});
            small.card().dampr.value = 0.1;
            small.card().viss.value = 1.0;
            small.model().as_built.set(Departure::D13, d13);
            Hand hand(small);
            hand.tools[0].angular_velocity = 3 * Vec3::Unit(axis);
            hand.step(0, 0);
            const ContactStep step = hand.step(0.1, 0.1);
            const double sum = d13 ? 0.1 * (1000 + std::sqrt(2000.0) / 0.1) : 100;  // D13: of k + C / dt
            const Vec3 expected = -3 * 2 * 0.1 * std::sqrt(5 * sum) * Vec3::Unit(axis);
            EXPECT_NEAR((step.tool.damping_moment - expected).norm(), 0, 1e-10) << axis;
            EXPECT_EQ(step.tool.damping_force, Vec3(0, 0, 0));  // Damp is 0
        }
    }
}

// I_0 = diag(4, 9, 25) turned by 90 degrees about z: about the global axes x, y, z it is 9, 4, 25; about (0, 0.6, 0.8)
// it is 4 * 0.36 + 25 * 0.64 = 17.44. As built it is 4 for every axis. No spin, no moment.
// @manual field Dampr; comment 19; departure D40
TEST(Contact, DamprUsesTheInertiaAboutTheAxisOfTheTurn) {
    const std::vector<std::pair<Vec3, double>> axes{
        {{1, 0, 0}, 9}, {{0, 1, 0}, 4}, {{0, 0, 1}, 25}, {{0, 0.6, 0.8}, 17.44}, {{0, 0, 0}, 1}};
    for (const auto& [axis, inertia] : axes) {
        for (const bool d40 : {false, true}) {
            SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}, {-0.2, 0.1, 0.3}});
            small.card().dampr.value = 0.1;
            small.model().rigid_bodies[0].inertia = Vec3(4, 9, 25).asDiagonal();
            small.model().as_built.set(Departure::D40, d40);
            Hand hand(small);
            hand.tools[0].rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
            hand.tools[0].angular_velocity = 3 * axis;
            const double arm = 2 * 1000 * (0.04 + 0.01);  // k |X - x_G|^2 of both nodes
            const Vec3 expected = -3 * 2 * 0.1 * std::sqrt((d40 ? 4.0 : inertia) * arm) * axis;
            EXPECT_NEAR((hand.step(0, 0).tool.damping_moment - expected).norm(), 0, 1e-9) << axis.transpose() << d40;
        }
    }
}

// @manual field Stfac; comment 6, 11
TEST(Contact, StfacAboveOneScalesTheForce) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    small.card().stfac.value = 3.0;
    EXPECT_NEAR(Hand(small).step(0, 0).nodes[0].force.z(), 3 * 1000 * 0.2, 1e-10);
}

// @manual departure D12
TEST(Contact, AsBuiltANodeOnTheSurfaceHasNoDirection) {
    SceneBuilder small = over_a_square({{0.25, 0.125, 0.0}});
    Hand documented(small);
    const ContactStep good = documented.step(0, 0);
    EXPECT_NEAR(good.nodes[0].force.z(), 500, 1e-10);
    small.model().as_built.set(Departure::D12);
    Hand built(small);
    const ContactStep bad = built.step(0, 0);
    EXPECT_EQ(bad.nodes[0].force, Vec3(0, 0, 0));
    EXPECT_NEAR(bad.sums.signed_normal, -500, 1e-10);  // while ||FN|| keeps it
}

TEST(Contact, InitialPenetrationsAreListedWithNodeAndValue) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.6}, {0.2, 0.1, 0.35}, {5, 5, 0.1}});
    const Contact contact(small.scene(), 0);
    const auto found = contact.initial_penetrations();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].node, small.blank_node(1));
    EXPECT_NEAR(found[0].penetration, 0.15, 1e-15);
    EXPECT_NEAR(found[0].distance, 0.35, 1e-15);
}

TEST(Contact, AnInterfaceThatIsNotThereIsNamed) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    for (const int interface : {-1, 1}) {
        try {
            make_contact(small.scene(), interface);
            FAIL() << interface;
        } catch (const std::out_of_range& error) {
            EXPECT_EQ(std::string(error.what()),
                      fmt::format("there is no interface {}: the model has 1, counted from 0", interface));
        }
    }
}

TEST(Contact, APositionThatIsNotFiniteHasNoImpact) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}, {0.2, 0.1, 0.3}});
    Hand hand(small);
    hand.x(0).x() = std::nan("");
    const ContactStep step = hand.step(0, 0);
    EXPECT_EQ(step.nodes[0].decision.kind, Kind::none);
    EXPECT_EQ(step.nodes[0].force, Vec3(0, 0, 0));
    EXPECT_NEAR(step.nodes[1].force.z(), 200, 1e-10);
}

TEST(Contact, AFirstCallAfterTimeZeroIsAFirstImpact) {
    for (const int inacti : {0, 1, 5, 6}) {
        SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
        small.card().inacti.value = inacti;
        Hand hand(small);
        const ContactStep step = hand.step(1e-3, 1e-3);
        EXPECT_NEAR(step.nodes[0].offset, 0.2, 1e-15) << "Inacti " << inacti;
        EXPECT_EQ(step.nodes[0].elastic_force, 0.0);
    }
}

}  // namespace
}  // namespace type21::reference
