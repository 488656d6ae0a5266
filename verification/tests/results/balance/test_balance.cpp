#include <gtest/gtest.h>

#include "verification/results/balance/balance.h"
#include "verification/tests/results/record/record_scene.h"

namespace type21 {
namespace {

using test::Cycle;
using test::RecordScene;

/// One node pressed, damped and rubbed by a turning tool, consistent in every digit but rounding.
struct OneNode {
    RecordScene small;
    Cycle cycle;

    OneNode() {
        ContactStep& step = cycle.contacts[0];
        step.active = true;
        step.nodes.resize(1);
        NodeContact& node = step.nodes[0];
        node.normal = Vec3(0.36, 0.48, 0.8);
        node.point = Vec3(1.4, 1.9, 2.8);
        node.elastic_force = 7;
        node.damping = 0.125;
        const Vec3 tool_velocity =
            cycle.velocity[1] + cycle.angular_velocity[1].cross(Vec3(node.point - cycle.position[1]));
        const Vec3 relative = cycle.velocity[0] - tool_velocity;
        const double vn = relative.dot(node.normal);
        node.normal_force = node.elastic_force - node.damping * vn;
        node.friction = Vec3(0.8, -0.6, 0) * 0.5;
        node.force = node.normal_force * node.normal - node.friction;
        step.sums.normal = -node.normal_force * node.normal;
        step.sums.tangential = node.friction;
        cycle.totals[0].damping_energy = 0.5 * node.damping * vn * vn;
        cycle.totals[0].friction_energy = 0.5 * relative.dot(node.friction);
    }

    InterfaceBalance balance() {
        BalanceObserver observer(small.scene);
        observer.observe(cycle.record(0, 0, 0.5, 1, true));
        return observer.result()[0];
    }
};

TEST(Balance, HoldsToRoundingWhereTheStepIsConsistent) {
    OneNode one;
    const InterfaceBalance balance = one.balance();
    EXPECT_EQ(balance.cycles_in_contact, 1);
    for (const char* name : {"force", "power", "CE_DAMP", "CE_FRIC"})
        EXPECT_LT(find_residual(balance, name)->relative, 1e-15) << name;
}

TEST(Balance, SeesAForceThatTheToolDoesNotGet) {
    OneNode one;
    one.cycle.contacts[0].sums.tangential = Vec3::Zero();
    EXPECT_GT(one.balance().force.relative, 1e-3);
    EXPECT_EQ(one.balance().force.cycle, 0);
}

TEST(Balance, SeesAForceOffTheNormal) {
    OneNode one;
    one.cycle.contacts[0].nodes[0].force += Vec3(0.01, 0, 0);
    EXPECT_GT(one.balance().power.relative, 1e-5);
}

TEST(Balance, SeesADampingThatTheForceDoesNotHave) {
    OneNode one;
    one.cycle.contacts[0].nodes[0].damping *= 1.01;
    EXPECT_GT(one.balance().power.relative, 1e-4);
}

TEST(Balance, SeesAForceThatActsElsewhereOnATurningTool) {
    OneNode one;
    // The force was computed with the tool's velocity at another point than its point of action.
    one.cycle.contacts[0].nodes[0].point += Vec3(0, 0, 0.5);
    // Its power is the same by the identity; what the laws dissipated is not.
    EXPECT_GT(one.balance().friction_energy.relative, 1e-4);
    EXPECT_GT(one.balance().damping_energy.relative, 1e-5);
}

TEST(Balance, SeesEnergiesThatAreNotTheWorkOfTheForces) {
    OneNode one;
    one.cycle.totals[0].damping_energy *= 1 + 1e-9;
    one.cycle.totals[0].friction_energy *= 1 + 1e-6;
    EXPECT_GT(one.balance().damping_energy.relative, 1e-11);
    EXPECT_GT(one.balance().friction_energy.relative, 1e-9);
}

TEST(Balance, ANotANumberIsTheWorstResidual) {
    OneNode one;
    one.cycle.contacts[0].nodes[0].force.x() = std::nan("");
    EXPECT_TRUE(std::isinf(one.balance().force.relative));
}

TEST(Balance, CountsNoCycleWithoutContact) {
    OneNode one;
    one.cycle.contacts[0] = {};
    one.cycle.totals[0] = {};
    EXPECT_EQ(one.balance().cycles_in_contact, 0);
}

}  // namespace
}  // namespace type21
