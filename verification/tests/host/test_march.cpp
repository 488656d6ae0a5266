// The march against motions whose exact answer is known.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "../contact/small_scene.h"
#include "reference/cycle/contact.h"
#include "reference/host/conditions.h"
#include "reference/host/march.h"
#include "reference/host/rotation.h"
#include "reference/host/time_step.h"

namespace type21 {
namespace {

using test::over_a_square;

std::unique_ptr<ContactMethod> reference_contact(const Scene& scene, int interface) {
    return std::make_unique<reference::Contact>(scene, interface);
}

/// What a test keeps of each cycle.
struct Kept {
    double time;
    std::vector<Vec3> displacement;
    std::vector<Vec3> velocity;
    std::vector<Vec3> reaction;
    ToolMotion tool;
    InterfaceTotals totals;
    ContactStep contact;
};

std::vector<Kept> run(SceneBuilder& small) {
    std::vector<Kept> kept;
    march(small.scene(), reference_contact, [&](const CycleRecord& r) {
        kept.push_back({r.time,
                        *r.displacement,
                        {r.motion->velocity.begin(), r.motion->velocity.end()},
                        *r.reaction,
                        r.motion->tools[0],
                        (*r.totals)[0],
                        (*r.contacts)[0]});
    });
    return kept;
}

constexpr std::array<bool, 6> all_fixed{true, true, true, true, true, true};

TEST(Rotation, FullTurnAboutAnyAxisTo1em12) {
    for (const Vec3& axis : {Vec3(1, 2, 3), Vec3(0, 0, 1), Vec3(-1, 1e-3, 0.5)}) {
        const Vec3 w = 2 * std::numbers::pi * axis.normalized();
        Rotation r = Rotation::Identity();
        for (int i = 0; i < 100000; ++i)
            r = turned(r, w, 1e-5);
        EXPECT_LT((r.toRotationMatrix() - Mat3::Identity()).norm(), 1e-12);
    }
    EXPECT_LT((exponential(Vec3(0, 0, std::numbers::pi / 2)) * Vec3(1, 0, 0) - Vec3(0, 1, 0)).norm(), 1e-15);
    EXPECT_LT((exponential(Vec3(1e-9, 0, 0)) * Vec3(0, 1, 0) - Vec3(0, 1, 1e-9)).norm(), 1e-24);
}

TEST(March, ImposedVelocityMovesTheToolAndItsNodes) {
    SceneBuilder small = over_a_square({{5, 5, 5}});
    small.fix(small.blank_node(0), all_fixed);
    small.fix(0, {true, true, false, true, true, true});
    small.drive(0, 2, -3.0);
    small.model().engine.end_time = 0.0105;
    const auto kept = run(small);
    ASSERT_EQ(kept.size(), 11u);
    EXPECT_EQ(kept[0].velocity[0], Vec3(0, 0, 0));  // v at n - 1/2 of the first cycle: the initial one
    EXPECT_EQ(kept[1].velocity[0].z(), -3.0);
    EXPECT_NEAR(kept[10].displacement[0].z(), -0.03, 1e-15);
    EXPECT_NEAR(kept[10].displacement[2].z(), -0.03, 1e-15);
    EXPECT_NEAR(kept[0].reaction[0].z(), -30.0, 1e-12);  // M dv, all in the first half step
}

TEST(March, ImposedDisplacementIsMetAtEveryTime) {
    SceneBuilder small = over_a_square({{5, 5, 5}});
    small.fix(small.blank_node(0), all_fixed);
    small.fix(0, {true, true, false, true, true, true});
    small.drive(0, 2, 2.5, ImposedMotion::Kind::displacement);
    small.model().engine.end_time = 0.02;
    for (const Kept& k : run(small))
        EXPECT_NEAR(k.displacement[0].z(), 2.5 * k.time, 1e-15);
}

// omega about an oblique axis, one turn in 0.1: the node is carried round a circle; exact position at every record.
TEST(March, ATurningToolKeepsItsNodesOnTheirCircle) {
    SceneBuilder small = over_a_square({{5, 5, 5}});
    small.fix(small.blank_node(0), all_fixed);
    small.fix(0, {true, true, true, false, false, false});
    const Vec3 axis = Vec3(1, -2, 0.5).normalized();
    const double rate = 20 * std::numbers::pi;
    for (int d = 0; d < 3; ++d)
        small.drive(0, d + 3, rate * axis[d]);
    small.model().engine.end_time = 0.1;
    const Vec3 arm = small.model().nodes.position[1];
    for (const Kept& k : run(small)) {
        const Vec3 exact = Eigen::AngleAxisd(rate * k.time, axis) * arm;
        ASSERT_LT((arm + k.displacement[1] - exact).norm(), 1e-12);
    }
}

// A node of mass 1 falls freely under its load: leapfrog gives x = a (n dt)^2 / 2 exactly for a half first step.
TEST(March, AFreeNodeUnderALoad) {
    SceneBuilder small = over_a_square({{5, 5, 5}});
    small.fix(0, all_fixed);
    Model& model = small.model();
    small.load(small.blank_node(0), 0, 4.0);
    model.engine.end_time = 0.1;
    const auto n = static_cast<size_t>(small.blank_node(0));
    for (const Kept& k : run(small))
        EXPECT_NEAR(k.displacement[n].x(), 2.0 * k.time * k.time, 1e-14);
}

// A bar-like inertia turning freely about a principal axis keeps its rate; a torque about it gives alpha = M / I.
TEST(March, AFreeToolTurnsWithItsInertia) {
    SceneBuilder small = over_a_square({{5, 5, 5}});
    small.fix(small.blank_node(0), all_fixed);
    Model& model = small.model();
    model.rigid_bodies[0].inertia = Vec3(2, 3, 4).asDiagonal();
    small.load(0, 5, 8.0);
    model.engine.end_time = 0.1;
    const auto kept = run(small);
    EXPECT_NEAR(kept.back().tool.angular_velocity.z(), 2.0 * (kept.back().time - 0.5e-3), 1e-12);  // at n - 1/2
}

// Undamped contact is a spring: starting at p = 0.1 from rest the node leaves with v = p sqrt(k / m), exactly to second
// order.
TEST(March, ASpringGivesBackItsEnergy) {
    SceneBuilder small = over_a_square({{0, 0, 0.4}});
    small.fix(0, all_fixed);
    small.model().engine.first_step = small.model().engine.largest_step = 1e-5;
    small.model().engine.end_time = 0.1;
    const auto n = static_cast<size_t>(small.blank_node(0));
    const auto kept = run(small);
    EXPECT_NEAR(kept.back().velocity[n].z(), 0.1 * std::sqrt(1000.0), 1e-6);
    EXPECT_EQ(kept.back().totals.elastic_energy, 0.0);
    // The impulse on the tool is the momentum that the node took away, to rounding.
    EXPECT_NEAR(kept.back().totals.normal.z(), -kept.back().velocity[n].z(), 1e-12);
}

// @manual departure D25
TEST(March, ImpulsesOfPageAndAsBuiltDifferByTheirWeights) {
    SceneBuilder small = over_a_square({{0, 0, 0.4}});
    small.fix(0, all_fixed);
    small.fix(small.blank_node(0), all_fixed);
    small.model().engine.end_time = 0.0025;
    const auto documented = run(small);  // F = 100, dt = 1e-3, cycles 0, 1, 2: w = dt/2, dt, dt
    ASSERT_EQ(documented.size(), 3u);
    EXPECT_NEAR(documented[0].totals.normal.z(), -0.05, 1e-15);
    EXPECT_NEAR(documented[2].totals.normal.z(), -0.25, 1e-15);
    EXPECT_NEAR(documented[2].reaction[static_cast<size_t>(small.blank_node(0))].z(), -0.25, 1e-15);
    small.model().as_built.set(Departure::D25);
    const auto built = run(small);  // 0, dt/2, dt
    EXPECT_EQ(built[0].totals.normal.z(), 0.0);
    EXPECT_NEAR(built[2].totals.normal.z(), -0.15, 1e-15);
    EXPECT_NEAR(built[2].reaction[static_cast<size_t>(small.blank_node(0))].z(), -0.25,
                1e-15);  // REAC keeps the current weight
}

// @manual departure D24
TEST(March, AsBuiltTheOrientationIsOneStepOld) {
    SceneBuilder small = over_a_square({{5, 5, 5}});
    small.fix(small.blank_node(0), all_fixed);
    small.fix(0, {true, true, true, true, true, false});
    small.drive(0, 5, 10.0);
    small.model().engine.end_time = 0.003;
    small.model().as_built.set(Departure::D24);
    const auto kept = run(small);
    const auto angle = [](const Kept& k) { return std::atan2(k.tool.rotation(1, 0), k.tool.rotation(0, 0)); };
    EXPECT_EQ(angle(kept[1]), 0.0);
    EXPECT_NEAR(angle(kept[2]), 0.01, 1e-15);
}

// @manual field Inacti; comment 8
TEST(March, InactiThreeMovesTheNodeOut) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    small.fix(0, all_fixed);
    small.fix(small.blank_node(0), all_fixed);
    small.card().inacti.value = 3;
    small.model().engine.end_time = 0.001;
    for (const Kept& k : run(small))
        EXPECT_EQ(k.contact.nodes[0].force, Vec3(0, 0, 0));
}

// Inacti 1 looks at time 0 also when the interface starts later: the node that penetrated then stays off.
// @manual field Inacti
TEST(March, InactiOneHoldsWhenTheInterfaceStartsLater) {
    for (const int inacti : {0, 1}) {
        SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
        small.fix(0, all_fixed);
        small.fix(small.blank_node(0), all_fixed);
        small.card().inacti.value = inacti;
        small.card().tstart.value = 0.0015;
        small.card().viss.value = 1.0;
        small.model().engine.end_time = 0.0045;
        EXPECT_EQ(run(small).back().contact.nodes[0].stiffness > 0 || run(small)[2].contact.nodes[0].stiffness > 0,
                  inacti == 0);
    }
}

TEST(Runnable, EveryReasonIsNamedAtOnce) {
    SceneBuilder small = over_a_square({{0, 0, 0.6}});
    Model& model = small.model();
    model.engine.end_time = 0;
    model.rigid_bodies[0].mass = 0;
    model.rigid_bodies[0].inertia.setZero();
    small.load(small.blank_node(0), 3, 1.0);
    Problems problems;
    check_runnable(small.scene(), problems);
    EXPECT_EQ(problems.error_count(), 4);  // moment on a node, mass, inertia, end time
}

// @manual field IBC; comment 7
TEST(March, AReleasedNodeMoves) {
    SceneBuilder small = over_a_square({{0, 0, 0.6}});
    small.fix(0, {true, true, false, true, true, true});
    small.drive(0, 2, 50.0);
    small.fix(small.blank_node(0), all_fixed);
    small.card().ibc.value = 1;  // Z
    small.model().engine.end_time = 0.02;
    const auto kept = run(small);
    const auto n = static_cast<size_t>(small.blank_node(0));
    EXPECT_GT(kept.back().velocity[n].z(), 1.0);
    small.card().ibc.value = 0;
    EXPECT_EQ(run(small).back().velocity[n].z(), 0.0);
}

TEST(March, StopsOnWhatIsNotANumber) {
    SceneBuilder small = over_a_square({{0, 0, 0.4}});
    small.fix(0, all_fixed);
    small.card().stfac.value = 1e308;  // Stfac S overflows
    small.card().stmax.value = std::numeric_limits<double>::infinity();
    try {
        run(small);
        FAIL() << "an infinite force went through";
    } catch (const RunStopped& stopped) {
        EXPECT_EQ(stopped.why, RunStopped::Why::diverged);
        EXPECT_NE(std::string(stopped.what())
                      .find(std::to_string(small.model().nodes.id[static_cast<size_t>(small.blank_node(0))])),
                  std::string::npos);
    }
}

TEST(March, StopsWhereNothingLimitsTheStep) {
    SceneBuilder small = over_a_square({{5, 5, 5}});
    small.fix(0, all_fixed);
    small.fix(small.blank_node(0), all_fixed);
    small.model().engine.first_step.reset();
    small.model().engine.largest_step.reset();
    EXPECT_THROW(run(small), RunStopped);
}

// @manual field Invn; comment 21
TEST(March, InvnStopsAfterTheCycleIsRecorded) {
    SceneBuilder small = over_a_square({{0.2, 0.1, -1.995}});
    small.fix(0, all_fixed);
    small.fix(small.blank_node(0), all_fixed);
    small.card().invn.value = 1;
    int records = 0;
    try {
        march(small.scene(), reference_contact, [&](const CycleRecord&) { ++records; });
        FAIL();
    } catch (const RunStopped& stopped) {
        EXPECT_EQ(stopped.why, RunStopped::Why::inverted_normal);
    }
    EXPECT_EQ(records, 1);
}

TEST(TimeStep, NodalAndKinematicLimits) {
    SceneBuilder small = over_a_square({{0, 0, 0.4}});
    small.model().engine.first_step.reset();
    small.model().engine.largest_step.reset();
    small.model().engine.step_scale = 0.5;
    const HostScene scene = small.scene();
    HostState state(small.model());
    TimeStep time_step(scene);
    ContactStep contact;
    contact.active = true;
    contact.nodes.resize(1);
    contact.nodes[0].step_stiffness = 5000;
    contact.tool.step_stiffness = 1e-3;
    state.cycle = 3;
    state.bodies[0].velocity = {0, 0, 40};
    const double step = time_step.next(state, {contact});
    EXPECT_NEAR(time_step.limits().nodal, 0.5 * std::sqrt(2.0 / 5000), 1e-15);
    // c = max(g, 0.1 max(DEPTH, g)) = max(0.5, 0.2); v_max = |0 - 40|
    EXPECT_NEAR(time_step.limits().kinematic, 0.9 * 0.5 / 40, 1e-15);
    EXPECT_EQ(step, std::min(time_step.limits().nodal, time_step.limits().kinematic));
    small.model().engine.history_interval = 1e-4;
    TimeStep recorded(small.scene());
    EXPECT_EQ(recorded.next(state, {contact}), 1e-4);
}

}  // namespace
}  // namespace type21
