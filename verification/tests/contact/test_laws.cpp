// The laws of one node, each against a number worked out beside it.
#include <cmath>

#include <gtest/gtest.h>

#include "reference/as_built/d01_d04_stiffness.h"
#include "reference/as_built/d05_elastic_energy.h"
#include "reference/as_built/d12_contact_normal.h"
#include "reference/as_built/d13_tool_damping.h"
#include "reference/contact/activity.h"
#include "reference/contact/contact_geometry.h"
#include "reference/contact/friction_increment.h"
#include "reference/contact/friction_law.h"
#include "reference/contact/normal_force.h"
#include "reference/contact/penetration_offset.h"
#include "reference/contact/stiffness.h"
#include "reference/contact/tool_damping.h"
#include "reference/model/model.h"

namespace type21::reference {
namespace {

// @manual field Inacti; comment 9
TEST(PenetrationOffset, OfTimeZero) {
    EXPECT_EQ(initial_offset(0, 0.2, 0.5, 5.0), 0.0);
    EXPECT_EQ(initial_offset(5, 0.2, 0.5, 5.0), 0.2);
    EXPECT_DOUBLE_EQ(initial_offset(6, 0.2, 0.5, 5.0), 0.465);  // 0.2 + 0.05 (0.5 + 5 - 0.2)
    EXPECT_EQ(initial_offset(6, 0.0, 0.5, 5.0), 0.0);
}

// @manual comment 9
TEST(PenetrationOffset, FollowsADecreasingPenetrationAndNeverGrows) {
    EXPECT_DOUBLE_EQ(relaxed_offset(0.2, 0, 0.1, 0.5), 0.195);  // 0.19 + 0.005
    EXPECT_EQ(relaxed_offset(0.2, 0, 0.3, 0.5), 0.2);
    EXPECT_DOUBLE_EQ(relaxed_offset(0.465, 6, 0.2, 0.5), 0.95 * 0.465 + 0.05 * 0.215);  // target 0.2 + 0.05 * 0.3
}

TEST(PenetrationOffset, WhereTheStiffnessActs) {
    EXPECT_TRUE(stiffness_acts(1e-9, 5, 0, false));
    EXPECT_FALSE(stiffness_acts(0.0, 5, 0, false));
    EXPECT_TRUE(stiffness_acts(0.0, 1, 5, false));  // first cycle of an impact: damping acts
    EXPECT_FALSE(stiffness_acts(0.0, 1, 5, true));  // but not at time 0 with Inacti 5, 6
    EXPECT_FALSE(stiffness_acts(0.0, 1, 6, true));
    EXPECT_TRUE(stiffness_acts(0.0, 1, 0, true));
}

// @manual field Istf, Stfac, Stmin, Stmax; departure D01
TEST(Stiffness, ScaledAndBounded) {
    Interface card;
    card.stfac.value = 0.3;
    card.stmin.value = 0;
    card.stmax.value = 1e30;
    EXPECT_DOUBLE_EQ(nodal_stiffness(card, 252000), 75600);
    card.stmax.value = 5e4;
    EXPECT_DOUBLE_EQ(nodal_stiffness(card, 252000), 5e4);
    card.stmin.value = card.stmax.value = 1e6;
    EXPECT_DOUBLE_EQ(nodal_stiffness(card, 252000), 1e6);
    EXPECT_DOUBLE_EQ(as_built::nodal_stiffness(card, 252000), 75600);
    card.istf.value = 1;
    EXPECT_DOUBLE_EQ(nodal_stiffness(card, 252000), 0.3);
}

// @manual field Stfac; comment 6, 11
TEST(Stiffness, StfacAboveOneHasNoUpperLimit) {
    Interface card;
    card.stmax.value = 1e30;
    for (const double stfac : {0.5, 1.0, 3.0, 1e6}) {
        card.stfac.value = stfac;
        EXPECT_DOUBLE_EQ(nodal_stiffness(card, 1000), stfac * 1000);
    }
}

// @manual departure D04
TEST(Stiffness, OfTheFrictionIncrement) {
    Interface card;
    EXPECT_EQ(friction_stiffness(card, 75600, 252000), 75600);
    EXPECT_EQ(as_built::friction_stiffness(card, 75600, 252000), 252000);
    card.istf.value = 1;
    EXPECT_EQ(friction_stiffness(card, 5e4, 252000), 5e4);
    EXPECT_EQ(as_built::friction_stiffness(card, 5e4, 252000), 1.0);
}

// @manual departure D05
TEST(NormalForce, ForceAndItsIntegral) {
    EXPECT_DOUBLE_EQ(elastic_force(252000, 0.01), 2520);
    EXPECT_DOUBLE_EQ(elastic_energy(252000, 0.01), 12.6);
    // d/dp of the energy is the force: central difference, exact for a quadratic.
    EXPECT_NEAR((elastic_energy(3.0, 0.25 + 0.125) - elastic_energy(3.0, 0.25 - 0.125)) / 0.25,
                elastic_force(3.0, 0.25), 1e-15);
    // D05: Stfac ^ (p^2), 1 at p = 0, 0 where k = 0.
    EXPECT_DOUBLE_EQ(as_built::elastic_energy(5e4, 5e4, 0.5), std::pow(5e4, 0.25));
    EXPECT_EQ(as_built::elastic_energy(5e4, 5e4, 0.0), 1.0);
    EXPECT_EQ(as_built::elastic_energy(5e4, 0.0, 0.5), 0.0);
}

// @manual field VISs
TEST(NormalForce, CriticalDamping) {
    EXPECT_DOUBLE_EQ(damping_coefficient(1.0, 200.0, 0.25), 10.0);  // sqrt(2 * 200 * 0.25)
    EXPECT_DOUBLE_EQ(damping_coefficient(0.2, 200.0, 0.25), 2.0);
    EXPECT_DOUBLE_EQ(step_stiffness(200, 10, 0.1), 300);
    EXPECT_DOUBLE_EQ(step_stiffness(200, 10, 0.0), 200);
}

// @manual eq 12; comment 14
TEST(Friction, SticksSlipsAndTurnsWithTheSurface) {
    const Vec3 z(0, 0, 1);
    // T = 100 * (0.3, 0, 5) * 0.1 = (3, 0, 50); its part along z goes.
    const auto stick = friction_force(Vec3::Zero(), 100, {0.3, 0, 5}, 0.1, z, 4.0);
    EXPECT_FALSE(stick.slips);
    EXPECT_NEAR((stick.force - Vec3(3, 0, 0)).norm(), 0, 1e-15);
    const auto slip = friction_force(stick.force, 100, {0, 0.4, 0}, 0.1, z, 2.5);  // T = (3, 4, 0)
    EXPECT_TRUE(slip.slips);
    EXPECT_NEAR((slip.force - Vec3(1.5, 2.0, 0)).norm(), 0, 1e-15);
    // The old force is projected with the increment: (3, 0, 0) on the plane normal to x is nothing.
    EXPECT_EQ(friction_force({3, 0, 0}, 100, Vec3::Zero(), 0.1, Vec3(1, 0, 0), 4.0).force, Vec3(0, 0, 0));
    // No limit, no force.
    EXPECT_EQ(friction_force({3, 0, 0}, 0, Vec3::Zero(), 0.1, z, 0.0).force, Vec3(0, 0, 0));
    EXPECT_FALSE(friction_force(Vec3::Zero(), 0, Vec3::Zero(), 0.1, z, 0.0).slips);
}

// @manual departure D13
TEST(ToolDamping, StiffnessOfTheContactOrOfTheTimeStep) {
    const ToolStiffness contact{1, 2};
    const ToolStiffness step{3, 4};
    EXPECT_EQ(tool_damping_stiffness(contact, step).translation, 1);
    EXPECT_EQ(tool_damping_stiffness(contact, step).rotation, 2);
    EXPECT_EQ(as_built::tool_damping_stiffness(contact, step).translation, 3);
    EXPECT_EQ(as_built::tool_damping_stiffness(contact, step).rotation, 4);
}

TEST(ToolDamping, ShareOfTheCritical) {
    EXPECT_DOUBLE_EQ(tool_damping_coefficient(0.1, 0.02, 5e4), 2 * 0.1 * std::sqrt(1000.0));
    EXPECT_EQ(tool_damping(2.0, {1, 0, 3}, {0, 0, 1}), Vec3(-2, 0, -4));
}

// @manual field Tstart, Tstop, sens_ID; comment 20
TEST(Activity, WindowOrSensorAlone) {
    Interface card;
    card.tstart.value = 1.0;
    card.tstop.value = 2.0;
    Motion motion;
    const auto at = [&](double time) {
        motion.time = time;
        return active(card, motion);
    };
    EXPECT_FALSE(at(0.999));
    EXPECT_TRUE(at(1.0));
    EXPECT_TRUE(at(2.0));
    EXPECT_FALSE(at(2.001));
    card.sensor = 1;
    motion.sensor_on = {true, false};
    EXPECT_FALSE(at(1.5));
    motion.sensor_on = {false, true};
    EXPECT_TRUE(at(5.0));
}

// @manual departure D12
TEST(ContactGeometry, DistanceRunsAlongTheInterpolatedNormal) {
    SubTriangle<double> t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    // From the projection test: n = (0.5, 0, 1), X = (0.5, 0, 0), P = X + 0.2 n, so delta = 0.2 |n|.
    const Vec3 p(0.6, 0, 0.2);
    const auto projection = project<double>(p, t, {});
    ASSERT_TRUE(projection);
    const auto geometry = contact_geometry(t, *projection);
    EXPECT_NEAR(geometry.distance, 0.2 * std::sqrt(1.25), 1e-15);
    EXPECT_NEAR((geometry.normal - Vec3(0.5, 0, 1) / std::sqrt(1.25)).norm(), 0, 1e-15);
    EXPECT_NEAR((geometry.point - Vec3(0.5, 0, 0)).norm(), 0, 1e-15);
    // As built agrees away from the surface, and has no direction on it.
    const auto built = as_built::contact_geometry(p, t, projection->weights);
    EXPECT_NEAR((built.normal - geometry.normal).norm(), 0, 1e-14);
    EXPECT_NEAR(built.distance, geometry.distance, 1e-15);
    const auto on_it = as_built::contact_geometry({0.5, 0, 0}, t, {0.5, 0.0});
    EXPECT_EQ(on_it.normal, Vec3(0, 0, 0));
    EXPECT_EQ(on_it.distance, 0.0);
}

TEST(ContactGeometry, BehindTheSurfaceTheNormalStillLooksOutward) {
    SubTriangle<double> t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    const auto projection = project<double>({0.2, 0.2, -0.4}, t, {});
    ASSERT_TRUE(projection);
    const auto geometry = contact_geometry(t, *projection);
    EXPECT_DOUBLE_EQ(geometry.distance, -0.4);
    EXPECT_EQ(geometry.normal, Vec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(geometric_penetration(0.5, geometry.distance, {0.2, 0.2, -0.4}), 0.9);
}

TEST(ContactGeometry, ATouchWithinRoundingIsNoImpact) {
    const double ulp = std::nextafter(8.0, 9.0) - 8.0;
    EXPECT_EQ(geometric_penetration(0.5, 0.5 - 16 * ulp, {8, 0, 0}), 0.0);
    EXPECT_GT(geometric_penetration(0.5, 0.5 - 17 * ulp, {8, 0, 0}), 0.0);
    EXPECT_EQ(geometric_penetration(0.5, 0.6, {8, 0, 0}), 0.0);
}

}  // namespace
}  // namespace type21::reference
