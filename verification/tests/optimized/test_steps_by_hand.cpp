// One interface of the optimized contact through a few cycles, every number by hand: nodes over one square, k = 1000,
// m = 1, A = 1, g = 0.5, DEPTH = 2. The first cycle is of time 0, one node after the other; the later ones run many at
// once unless an effect forbids it.
#include <cmath>

#include <gtest/gtest.h>

#include "optimized/contact.h"
#include "optimized/projection/exact.h"
#include "optimized/search/search.h"
#include "verification/tests/contact/small_scene.h"

namespace type21::optimized {
namespace {

using test::over_a_square;

/// Positions and velocities of a SceneBuilder that a test moves by hand.
struct Hand {
    explicit Hand(SceneBuilder& scene)
        : small(scene),
          position(scene.model().nodes.position),
          velocity(position.size(), Vec3::Zero()),
          temperature(position.size(), 900.0),
          contact(scene.scene(), 0) {
        tools.emplace_back();
    }
    ContactStep step(double time, double dt) {
        Motion motion;
        motion.time = time;
        motion.step = motion.friction_step = dt;
        motion.position = position;
        motion.velocity = velocity;
        motion.temperature = temperature;
        motion.thickness = thickness;
        motion.tools = tools;
        motion.sensor_on = sensor_on;
        return contact.step(motion);
    }
    size_t node(int i) const { return static_cast<size_t>(small.blank_node(i)); }
    Vec3& x(int i) { return position[node(i)]; }
    Vec3& v(int i) { return velocity[node(i)]; }

    SceneBuilder& small;
    std::vector<Vec3> position;
    std::vector<Vec3> velocity;
    std::vector<double> temperature, thickness;
    std::vector<ToolMotion> tools;
    std::vector<bool> sensor_on;
    Contact contact;
};

// @manual field surf_IDm, IDrby
TEST(OptimizedSteps, TheToolStandsAboutTheCentreOfItsRigidBody) {
    SceneBuilder small = over_a_square({{0, 0, 1}});
    small.model().rigid_bodies[0].center = {1, 2, 3};
    const Tool tool(small.model(), small.card());
    ASSERT_EQ(tool.size(), 1);
    EXPECT_EQ(to_vec3(tool.segment(0).node[0]), Vec3(-2, -3, -3));
    EXPECT_EQ(to_vec3(tool.segment(0).normal[0]), Vec3(0, 0, 1));
}

double force_at_start(SceneBuilder& small) {
    return Hand(small).step(0, 0).nodes[0].force.z();
}

// @manual field Istf, Stfac, Stmin, Stmax; comment 6, 11; departure D01
TEST(OptimizedSteps, StiffnessIsScaledAndBounded) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    EXPECT_NEAR(force_at_start(small), 200, 1e-10);
    small.card().stfac.value = 3;
    EXPECT_NEAR(force_at_start(small), 600, 1e-10) << "no upper limit of the factor";
    small.card().stmax.value = 2000;
    EXPECT_NEAR(force_at_start(small), 400, 1e-10);
    small.model().as_built.set(Departure::D01);
    EXPECT_NEAR(force_at_start(small), 600, 1e-10);
    small.model().as_built.set(Departure::D01, false);
    small.card().stmin.value = small.card().stmax.value = 4000;
    EXPECT_NEAR(force_at_start(small), 800, 1e-10);
    small.card().istf.value = 1;
    small.card().stfac.value = 700;
    EXPECT_NEAR(force_at_start(small), 140, 1e-10);
}

// @manual field DEPTH; comment 4
TEST(OptimizedSteps, NoForceDeeperThanDepth) {
    SceneBuilder small = over_a_square({{0.2, 0.1, -1.99}, {0.2, 0.1, -2.0}, {0.2, 0.1, 0.5}});
    const ContactStep step = Hand(small).step(0, 0);
    EXPECT_NEAR(step.nodes[0].force.z(), 2490, 1e-9);
    EXPECT_EQ(step.nodes[1].decision.kind, Kind::none);
    EXPECT_EQ(step.nodes[2].decision.kind, Kind::none);
}

// @manual field Tstart, Tstop, sens_ID; comment 20
TEST(OptimizedSteps, WindowOrSensorAlone) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    small.card().tstart.value = 0.5;
    small.card().tstop.value = 0.7;
    Hand window(small);
    EXPECT_FALSE(window.step(0.4, 0.1).active);
    EXPECT_TRUE(window.step(0.5, 0.1).active);
    EXPECT_FALSE(window.step(0.71, 0.1).active);
    small.card().sensor = 0;
    Hand sensor(small);
    sensor.sensor_on = {false};
    EXPECT_FALSE(sensor.step(0.6, 0.1).active) << "Tstart has no say";
    sensor.sensor_on = {true};
    EXPECT_TRUE(sensor.step(0.8, 0.1).active) << "Tstop has no say";
}

// @manual field Inacti; comment 9
TEST(OptimizedSteps, InactiStartsWithAnOffset) {
    for (const int inacti : {1, 5}) {
        SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
        small.card().inacti.value = inacti;
        Hand hand(small);
        EXPECT_EQ(hand.step(0, 0).nodes[0].force, Vec3(0, 0, 0)) << inacti;
        hand.x(0).z() = 0.25;
        EXPECT_NEAR(hand.step(1e-3, 1e-3).nodes[0].force.z(), inacti == 5 ? 50 : 0, 1e-10) << inacti;
    }
}

// Away at time 0, then deep by 0.2 and by 0.1: Inacti 6 relaxes towards more than the penetration, but not with D26.
// @manual field Inacti; comment 9; departure D26
TEST(OptimizedSteps, D26ForgetsInacti6WhereNothingPenetratesAtTimeZero) {
    for (const bool d26 : {false, true}) {
        SceneBuilder small = over_a_square({{0.2, 0.1, 0.6}});
        small.card().inacti.value = 6;
        small.model().as_built.set(Departure::D26, d26);
        Hand hand(small);
        hand.step(0, 0);
        hand.x(0).z() = 0.3;
        hand.step(1e-3, 1e-3);
        hand.x(0).z() = 0.4;
        const double toward = d26 ? 0.1 : 0.1 + 0.05 * 0.4;
        EXPECT_NEAR(hand.step(2e-3, 1e-3).nodes[0].offset, 0.95 * 0.2 + 0.05 * toward, 1e-12);
    }
}

// In the first cycle of a later impact the stiffness damps and gives no force: -VISs sqrt(2 k m) v_n.
// @manual field VISs; comment 9
TEST(OptimizedSteps, FirstCycleOfALaterImpactHasDampingOnly) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.6}});
    small.card().viss.value = 0.5;
    Hand hand(small);
    hand.step(0, 0);
    hand.x(0).z() = 0.4;
    hand.v(0).z() = -3;
    const NodeContact first = hand.step(0.1, 0.1).nodes[0];
    EXPECT_EQ(first.elastic_force, 0.0);
    EXPECT_NEAR(first.normal_force, 0.5 * std::sqrt(2000.0) * 3, 1e-10);
}

/// A node with a shell that has grown by 0.1, so that the gap is 0.55 (0.5 + 0.1 / 2), at the height z: p = 0.55 - z.
/// P_A = 10 with k * 0.05 = 50.
NodeContact on_the_plateau(double z, int itlim, double fric) {
    SceneBuilder small = over_a_square({{0.2, 0.1, z}});
    Model& model = small.model();
    const int node = small.blank_node(0);
    model.shells.push_back({1, {node, 0, 1, 2}, 0, 1.0});
    model.parts.resize(1);
    model.parts[0].material = 0;
    model.materials.resize(1);
    model.materials[0].law = MaterialLaw::elastic;
    Interface& card = small.card();
    card.igap.value = 2;
    card.fscalegap.value = 1;
    card.pmax.value = 10;
    card.itlim.value = itlim;
    card.fric.value = fric;
    card.secondary.thickness[0] = 1;
    Hand hand(small);
    hand.thickness = {1.1};
    hand.step(0, 0);
    hand.v(0).x() = 1;
    return hand.step(0.1, 0.1).nodes[0];
}

// @manual eq 5, 6; field Igap, Pmax, ITlim; comment 5
TEST(OptimizedSteps, PmaxLimitsTheNormalAndTheTangentialForce) {
    EXPECT_NEAR(on_the_plateau(0.545, 1, 0).elastic_force, 5, 1e-9);
    EXPECT_NEAR(on_the_plateau(0.52, 1, 0).elastic_force, 10, 1e-9);
    const NodeContact deep = on_the_plateau(0.45, 1, 0.3);
    EXPECT_NEAR(deep.elastic_force, 60, 1e-9);
    EXPECT_NEAR(deep.friction.x(), 18, 1e-9);
    EXPECT_NEAR(on_the_plateau(0.45, 0, 0.3).friction.x(), 10 / std::sqrt(3.0), 1e-9);
}

// @manual eq 12; field Fric; comment 12, 14
TEST(OptimizedSteps, CoulombFrictionBuildsUpAndSlips) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.4}});
    small.card().fric.value = 0.1;
    Hand hand(small);
    hand.v(0).x() = 0.02;
    hand.step(0, 0);
    const ContactStep stick = hand.step(0.1, 0.1);  // k v dt = 1000 * 0.02 * 0.1 = 2 < mu F = 0.1 * 100
    EXPECT_NEAR(stick.nodes[0].friction.x(), 2, 1e-12);
    EXPECT_EQ(stick.nodes[0].status, Status::stick);
    hand.v(0).x() = 1;
    const ContactStep slip = hand.step(0.2, 0.1);
    EXPECT_NEAR(slip.nodes[0].friction.x(), 10, 1e-12);
    EXPECT_EQ(slip.nodes[0].status, Status::slip);
    EXPECT_NEAR(slip.nodes[0].force.x(), -10, 1e-12);
}

// @manual field Pskid
TEST(OptimizedSteps, TheSkidLineKeepsTheLargestRatio) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    small.card().fric.value = 0.1;
    small.card().pskid.value = 100;
    Hand hand(small);
    hand.v(0).x() = 1e3;
    EXPECT_NEAR(hand.step(0, 0).skid[0], 0, 1e-15);
    EXPECT_NEAR(hand.step(0.1, 0.1).skid[0], 20 * std::sqrt(3.0) / 100, 1e-12);
    hand.v(0).x() = 0;
    hand.x(0).z() = 0.4;
    EXPECT_NEAR(hand.step(0.2, 0.1).skid[0], 20 * std::sqrt(3.0) / 100, 1e-12);
}

/// F_n = 200, Fric 0.1, f_IDF(x) = x / 1000, AscaleF 2; T_s = 300, the tool has 900, Tint 500.
double friction_of_a_hot_node(bool d08) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    Interface& card = small.card();
    card.ithe.value = card.ithe_form.value = 1;
    card.tint.value = 500;
    card.fric.value = 0.1;
    card.ascalef.value = 2;
    card.fct_idf.value = 1;
    card.function_friction = 0;
    small.model().functions.push_back({1, "", {0.0, 1000.0}, {0.0, 1.0}});
    small.model().as_built.set(Departure::D08, d08);
    Hand hand(small);
    hand.temperature[hand.node(0)] = 300;
    hand.v(0).x() = 1e3;
    hand.step(0, 0);
    return hand.step(1e-3, 1e-3).nodes[0].friction.x();
}

// mu = 0.1 f(2 (300 + 900) / 2) = 0.12; as built 0.1 f((300 + 500) / 2) = 0.04.
// @manual eq 7, 8; field fct_IDF, AscaleF; comment 12; departure D08
TEST(OptimizedSteps, FrictionFollowsTheMeanTemperature) {
    EXPECT_NEAR(friction_of_a_hot_node(false), 0.12 * 200, 1e-10);
    EXPECT_NEAR(friction_of_a_hot_node(true), 0.04 * 200, 1e-10);
}

// Fric f = 0.1 (1 - 2 T/1000) at T = (300 + 900)/2 is -0.02: no friction, and a notice; D39: it drives with 4.
// @manual eq 7, 8; field Fric, fct_IDF; comment 12; departure D39
TEST(OptimizedSteps, FrictionBelowZero) {
    for (const bool d39 : {false, true}) {
        SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}, {0.3, 0.1, 0.3}});
        Interface& card = small.card();
        card.ithe.value = card.ithe_form.value = 1;
        card.fric.value = 0.1;
        card.fct_idf.value = 1;
        card.function_friction = 0;
        small.model().functions.push_back({1, "", {0.0, 100.0}, {1.0, 0.8}});
        small.model().as_built.set(Departure::D39, d39);
        Hand hand(small);
        hand.temperature[hand.node(0)] = hand.temperature[hand.node(1)] = 300;
        hand.v(0).x() = hand.v(1).x() = 1e3;
        hand.step(0, 0);
        const ContactStep step = hand.step(1e-3, 1e-3);
        EXPECT_NEAR(step.nodes[0].friction.x(), d39 ? -0.02 * 200 : 0, 1e-10);
        EXPECT_EQ(step.friction_below_zero.count, 2);
        EXPECT_EQ(step.friction_below_zero.node, small.blank_node(0));
        EXPECT_NEAR(step.friction_below_zero.abscissa, 600, 1e-10);
        EXPECT_NEAR(step.friction_below_zero.coefficient, -0.02, 1e-15);
    }
}

// e^(C2 s) with C2 s = 1000 is no double: C1 0.1 makes mu infinite, and the step names C2 and the speed.
// @manual eq 11; comment 13; departure D43
TEST(OptimizedSteps, AFrictionLawThatOverflowsIsNamed) {
    for (const bool d43 : {false, true}) {
        SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}, {0.3, 0.1, 0.3}});
        Interface& card = small.card();
        card.ifric.value = 2;
        card.fric.value = 0.1;
        card.c[0].value = 0.1;
        card.c[1].value = 1;
        small.model().as_built.set(Departure::D43, d43);
        Hand hand(small);
        hand.v(0).x() = 1e3;
        hand.step(0, 0);
        const FrictionOverflow overflow = hand.step(1e-3, 1e-3).friction_overflow;
        EXPECT_EQ(overflow.count, d43 ? 0 : 1);
        if (d43) continue;
        EXPECT_EQ(overflow.node, small.blank_node(0));
        EXPECT_EQ(overflow.coefficient, 1);
        EXPECT_EQ(overflow.value, 1);
        EXPECT_NEAR(overflow.speed, 1e3, 1e-10);
        EXPECT_NEAR(overflow.pressure, 200, 1e-9);
    }
}

// A node that slides with mu F_n = 20 loses (|T| - 20) 20 / k; half of it heats the blank, with D16 the tool, too.
// @manual eq 19; field Fheat, Ithe, Tint, Ithe_form; comment 16, 18; departure D16
TEST(OptimizedSteps, FrictionHeatAndTheTemperatureOfTheTool) {
    for (const bool d16 : {false, true}) {
        for (const int form : {0, 1}) {
            SceneBuilder small = over_a_square({{0.2, 0.1, -0.1}});
            Interface& card = small.card();
            card.ithe.value = 1;
            card.ithe_form.value = form;
            card.kthe.value = 20;
            card.ascalek.value = 1;
            card.tint.value = 500;
            card.fheat.value = 0.5;
            card.fric.value = 0.1;
            small.model().as_built.set(Departure::D16, d16);
            Hand hand(small);
            hand.temperature[hand.node(0)] = 300;
            hand.step(0, 0);
            hand.v(0).x() = 10;
            const ContactStep step = hand.step(0.1, 0.1);  // F_n = 600, limit 60, |T| = 1000 * 10 * 0.1
            const double friction_heat = 0.5 * (1000 - 60) * 60 / 1000.0;
            const double conducted = 20 * ((form == 1 ? 900 : 500) - 300) * 0.1;
            EXPECT_NEAR(step.heat[0].friction_heat, friction_heat, 1e-10);
            EXPECT_NEAR(step.heat[0].heat, conducted + friction_heat, 1e-9);
            EXPECT_NEAR(step.sums.heat_to_tool, form == 0 ? 0 : (d16 ? friction_heat : 0) - conducted, 1e-9);
        }
    }
}

// Two nodes at (+-0.2, 0.1, 0) from x_G: the sum of k is 2000, that of k |X - x_G|^2 is 100. M = 10, I = 5.
// @manual field Damp, Dampr; comment 19; departure D13
TEST(OptimizedSteps, ToolDampingOfBothMotions) {
    for (const bool d13 : {false, true}) {
        for (int axis = 0; axis < 3; ++axis) {
            SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}, {-0.2, 0.1, 0.3}});
            small.card().damp.value = 0.2;
            small.card().dampr.value = 0.1;
            small.card().viss.value = 1.0;
            small.model().as_built.set(Departure::D13, d13);
            Hand hand(small);
            hand.tools[0].velocity = 2 * Vec3::Unit(axis);
            hand.tools[0].angular_velocity = 3 * Vec3::Unit(axis);
            hand.step(0, 0);
            const ContactStep step = hand.step(0.1, 0.1);
            const double k = d13 ? 1000 + std::sqrt(2000.0) / 0.1 : 1000;  // D13: with C / dt
            const Vec3 force = -2 * 2 * 0.2 * std::sqrt(10 * 2 * k) * Vec3::Unit(axis);
            const Vec3 moment = -3 * 2 * 0.1 * std::sqrt(5 * 0.1 * k) * Vec3::Unit(axis);
            EXPECT_NEAR((step.tool.damping_force - force).norm(), 0, 1e-9) << axis;
            EXPECT_NEAR((step.tool.damping_moment - moment).norm(), 0, 1e-9) << axis;
        }
    }
}

// I = diag(4, 9, 25) turned by 90 degrees about z: about the global axes x, y, z it is 9, 4, 25; about (0, 0.6, 0.8) it
// is 4 * 0.36 + 25 * 0.64 = 17.44. As built it is 4 for every axis. No spin, no moment.
// @manual field Dampr; comment 19; departure D40
TEST(OptimizedSteps, DamprUsesTheInertiaAboutTheAxisOfTheTurn) {
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
            const Vec3 moment = -3 * 2 * 0.1 * std::sqrt((d40 ? 4.0 : inertia) * arm) * axis;
            EXPECT_NEAR((hand.step(0, 0).tool.damping_moment - moment).norm(), 0, 1e-9) << axis.transpose() << d40;
        }
    }
}

// A flat quad with a triangle that stands on its edge, listed twice: the normal of the edge leans by atan(1/2), where
// the second is not noted (D41) by atan(2/2).
// @manual field surf_IDm
TEST(OptimizedSteps, ARepeatedSegmentCountsOnceInTheNormals) {
    for (const bool noted : {true, false}) {
        SceneBuilder small = test::small_scene(
            {{{-9, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-9, 1, 0}, {0, 0.5, 1}}, {{0, 1, 2, 3}, {1, 2, 4, 4}, {1, 2, 4, 4}}},
            {{-9, 0.5, 0.3}});
        if (noted) small.model().surfaces[static_cast<size_t>(small.card().main_surface)].repeated = {2};
        const Tool tool(small.model(), small.card());
        const V3 normal = tool.normal(0, 1);
        EXPECT_NEAR(normal.z / normal.x, noted ? 2 : 1, 1e-14);
        EXPECT_EQ(tool.size(), 3);
    }
}

// The reference interface moves a second tool by 1: C brakes the difference 2 - 1. C = 2 * 0.2 sqrt(10 * 1000).
// @manual field Damp, IDref; comment 19
TEST(OptimizedSteps, DampingAgainstTheToolOfIdref) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    small.card().damp.value = 0.2;
    small.card().reference_interface = 1;
    Model& model = small.model();
    model.rigid_bodies.push_back(model.rigid_bodies[0]);
    model.interfaces.push_back(model.interfaces[0]);
    model.interfaces[1].tool = 1;
    Hand hand(small);
    hand.tools.resize(2);
    hand.tools[0].velocity = {0, 0, 2};
    hand.tools[1].velocity = {0, 0, 1};
    hand.step(0, 0);
    EXPECT_NEAR(hand.step(0.1, 0.1).tool.damping_force.z(), -0.4 * std::sqrt(1e4), 1e-10);
}

// Stfac 3: the friction increment is 3000 * 0.002 * 0.1, with D04 that of S = 1000.
// @manual departure D04
TEST(OptimizedSteps, StiffnessOfTheFrictionIncrement) {
    for (const bool d04 : {false, true}) {
        SceneBuilder small = over_a_square({{0.2, 0.1, 0.4}});
        small.card().stfac.value = 3;
        small.card().fric.value = 0.1;
        small.model().as_built.set(Departure::D04, d04);
        Hand hand(small);
        hand.step(0, 0);
        hand.v(0).x() = 0.002;
        EXPECT_NEAR(hand.step(0.1, 0.1).nodes[0].friction.x(), d04 ? 0.2 : 0.6, 1e-13);
    }
}

// Istf 1 with Stfac 700 and p = 0.2: as built the energy is Stfac to the power p^2.
// @manual departure D05
TEST(OptimizedSteps, ElasticEnergyAsBuiltIsAPower) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    small.card().istf.value = 1;
    small.card().stfac.value = 700;
    EXPECT_NEAR(Hand(small).step(0, 0).nodes[0].elastic_energy, 14, 1e-10);
    small.model().as_built.set(Departure::D05);
    EXPECT_NEAR(Hand(small).step(0, 0).nodes[0].elastic_energy, std::pow(700, 0.04), 1e-10);
}

// The gap is 0.6 / 2 = 0.3, the largest of time 0 is 0.5: at 0.4 there is contact with D33, without a force.
// @manual field Igap; departure D33
TEST(OptimizedSteps, D33SearchesWithTheLargestGap) {
    for (const bool d33 : {false, true}) {
        SceneBuilder small = over_a_square({{0.2, 0.1, 0.4}});
        small.card().igap.value = 2;
        small.card().fscalegap.value = 1;
        small.card().secondary.thickness[0] = 0.6;
        small.model().as_built.set(Departure::D33, d33);
        const NodeContact node = Hand(small).step(0, 0).nodes[0];
        EXPECT_DOUBLE_EQ(node.gap, 0.3);
        EXPECT_EQ(node.decision.kind, d33 ? Kind::contact : Kind::none);
        EXPECT_EQ(node.force, Vec3(0, 0, 0));
    }
}

// mu = 0.1 + 0.001 p, and p = 200 on A = 1.
// @manual eq 9; field Ifric
TEST(OptimizedSteps, AFrictionLawOfManyNodes) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    small.card().ifric.value = 1;
    small.card().fric.value = 0.1;
    small.card().c[0].value = 0.001;
    Hand hand(small);
    hand.v(0).x() = 1e3;
    hand.step(0, 0);
    EXPECT_NEAR(hand.step(0.1, 0.1).nodes[0].friction.x(), 0.3 * 200, 1e-10);
}

// A square of side 2 with normals z, gap 0.5, DEPTH 1: the box grows by 1 % of its sides 2 and 1.5.
// @manual departure D34
TEST(OptimizedSteps, TheReachBoxGrowsByOnePercentOfItsSize) {
    const V3 z{0, 0, 1};
    const SegmentData square{{V3{-1, -1, 0}, V3{1, -1, 0}, V3{1, 1, 0}, V3{-1, 1, 0}}, {z, z, z, z}, false};
    ReachBoxRule rule;
    rule.on = true;
    const ContactReach window{0.5, 1.0, 0.0};
    EXPECT_TRUE(rule.holds({1.02, 0, 0}, square, window));
    EXPECT_FALSE(rule.holds({1.0201, 0, 0}, square, window));
    EXPECT_TRUE(rule.holds({0, 0, 0.515}, square, window));
    EXPECT_FALSE(rule.holds({0, 0, 0.5151}, square, window));
    EXPECT_FALSE(rule.holds({0, 0, -1.0151}, square, window));
}

// The triangle A (0, 0), B (1, 0), C (0, 1) with gap 0.5 and DEPTH 2; then the normal of B lies in its plane.
// @manual field DEPTH; comment 4; departure D35
TEST(OptimizedSteps, AnExactLandingKnowsDepthAndLeaningNormals) {
    const V3 z{0, 0, 1}, a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
    const ContactReach window{0.5, 2.0, 0.0};
    ProjectionLimits rules;
    const SegmentData flat{{b, c, a, a}, {z, z, z, z}, true};
    EXPECT_TRUE(project_exact({0.2, 0.2, -1.99}, flat, 1, window, rules).taken);
    EXPECT_FALSE(project_exact({0.2, 0.2, -2.0}, flat, 1, window, rules).taken);
    EXPECT_FALSE(project_exact({0.2, 0.2, 0.5}, flat, 1, window, rules).taken);
    const SegmentData leaning{{b, c, a, a}, {b, z, z, z}, true};
    EXPECT_FALSE(project_exact({0.0, 0.25, 0.1}, leaning, 1, window, rules).taken);
    rules.lift_leaning = true;
    EXPECT_TRUE(project_exact({0.0, 0.25, 0.1}, leaning, 1, window, rules).taken);
}

// @manual departure D12
TEST(OptimizedSteps, AsBuiltANodeOnTheSurfaceHasNoDirection) {
    SceneBuilder small = over_a_square({{0.25, 0.125, 0.0}});
    EXPECT_NEAR(force_at_start(small), 500, 1e-10);
    small.model().as_built.set(Departure::D12);
    EXPECT_EQ(force_at_start(small), 0.0);
}

// 3 % beyond the border of the square: outside of the margin of 1 %, inside of that of 5 %.
// @manual comment 8; departure D31
TEST(OptimizedSteps, D31FindsTheFirstImpactWithWiderMargins) {
    SceneBuilder small = over_a_square({{1.03, 0.1, 0.3}});
    const auto found = [&] { return Contact(small.scene(), 0).initial_penetrations(small.model().nodes.position); };
    EXPECT_TRUE(found().empty());
    small.model().as_built.set(Departure::D31);
    ASSERT_EQ(found().size(), 1u);
    EXPECT_NEAR(found()[0].penetration, 0.2, 1e-12);
    small.model().as_built.set(Departure::D31, false);
    small.model().nodes.position[static_cast<size_t>(small.blank_node(0))].x() = 0.2;
    ASSERT_EQ(found().size(), 1u);
    EXPECT_NEAR(found()[0].penetration, 0.2, 1e-12);
}

// @manual field IBC; comment 7
TEST(OptimizedSteps, IbcReleasesOnceAtTheFirstEffectivePenetration) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.6}});
    small.card().ibc.value = 1;
    Hand hand(small);
    hand.step(0, 0);
    hand.x(0).z() = 0.45;
    EXPECT_TRUE(hand.step(0.1, 0.1).released.empty());  // first cycle: p = 0
    hand.x(0).z() = 0.44;
    EXPECT_EQ(hand.step(0.2, 0.1).released, std::vector<int>{small.blank_node(0)});
    EXPECT_TRUE(hand.step(0.3, 0.1).released.empty());
    SceneBuilder deep = over_a_square({{0.2, 0.1, 0.3}});
    deep.card().ibc.value = 1;
    EXPECT_EQ(Hand(deep).step(0, 0).released, std::vector<int>{deep.blank_node(0)}) << "at time 0, too";
}

// @manual field Invn; comment 21
TEST(OptimizedSteps, InvnNamesTheNodeThatCameFromBehind) {
    SceneBuilder small = over_a_square({{0.2, 0.1, -1.99}, {0.2, 0.1, -1.9}});
    small.card().invn.value = 1;
    const ContactStep step = Hand(small).step(0, 0);
    ASSERT_EQ(step.inverted.size(), 1u);  // p_g > 0.5 + 0.99 * 2 = 2.48: 2.49 is, 2.40 is not
    EXPECT_EQ(step.inverted[0].node, small.blank_node(0));
    SceneBuilder later = over_a_square({{5, 0.1, -1.99}});
    later.card().invn.value = 1;
    Hand hand(later);
    EXPECT_TRUE(hand.step(0, 0).inverted.empty());
    hand.x(0).x() = 0.2;
    EXPECT_EQ(hand.step(0.1, 0.1).inverted.size(), 1u) << "the first impact is later";
}

// @manual field Idel
TEST(OptimizedSteps, ANodeLeavesWithItsLastShell) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    const int node = small.blank_node(0);
    small.model().parts.resize(1);
    small.model().parts[0].material = 0;
    small.model().materials.resize(1);
    small.model().shells = {{1, {node, 0, 1, 2}, 0, 1.0}, {2, {node, 2, 3, 4}, 0, 1.0}};
    small.card().idel.value = 2;
    Hand hand(small);
    hand.thickness = {0.0, 1.0};
    EXPECT_NEAR(hand.step(0, 0).nodes[0].force.z(), 200, 1e-10);
    hand.thickness = {0.0, 0.0};
    EXPECT_EQ(hand.step(0.1, 0.1).nodes[0].force, Vec3(0, 0, 0));
}

}  // namespace
}  // namespace type21::optimized
