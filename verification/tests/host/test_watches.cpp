// What a run watches: steps above the stability limit, energy from nowhere, a time that stands still, numbers that are
// not finite.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "../contact/small_scene.h"
#include "reference/contract/make_contact.h"
#include "reference/host/conditions.h"
#include "reference/host/march.h"
#include "reference/host/step_watch.h"
#include "verification/tests/deck/problem_search.h"

namespace type21::watches {
namespace {

using test::over_a_square;

/// How a run ended, and what it said.
struct End {
    long cycles = 0;
    std::string stop;
    std::vector<std::string> warnings;
};

End run(const SceneBuilder& small) {
    End end;
    MarchOptions options;
    options.warn = [&](const std::string& text) { end.warnings.push_back(text); };
    try {
        march(
            small.scene(), [](const Scene& scene, int i) { return reference::make_contact(scene, i); },
            [&](const CycleRecord& r) { end.cycles = r.cycle + 1; }, options);
    } catch (const RunStopped& stopped) {
        end.stop = stopped.what();
    }
    return end;
}

/// A node of mass 1 is thrown at the tool with a speed of 5; its stiffness of 1000 asks for steps below 0.0447.
SceneBuilder thrown(double step) {
    SceneBuilder small = over_a_square({{0, 0, 0.6}});
    small.hold(0);
    Model& model = small.model();
    small.load(small.blank_node(0), 0, 0.0);  // for its group
    InitialVelocity initial;
    initial.velocity = {0, 0, -5};
    initial.group = model.loads.back().group;
    model.initial_velocities = {initial};
    small.time_steps(step, 0.5);
    return small;
}

TEST(EnergyWatch, AStepFarBeyondTheLimitStopsTheRun) {
    // First impact in cycle 1. In cycle 2 it is deeper by 1: an elastic energy of 500, where 12.5 were put in.
    const End end = run(thrown(0.2));
    EXPECT_NE(end.stop.find("energy grows"), std::string::npos) << end.stop;
    EXPECT_NE(end.stop.find("in cycle 2 at t = 0.4"), std::string::npos) << end.stop;
    EXPECT_NE(end.stop.find("12.5 "), std::string::npos) << "the energy put in: " << end.stop;
    ASSERT_EQ(end.warnings.size(), 1U) << "said although the run stopped";
    EXPECT_NE(end.warnings[0].find("4.47 times"), std::string::npos) << end.warnings[0];
}

TEST(EnergyWatch, AStableBounceIsNoMatter) {
    for (const double step : {1e-3, 0.02, 0.04}) {
        const End end = run(thrown(step));
        EXPECT_EQ(end.stop, "") << step;
        EXPECT_TRUE(end.warnings.empty()) << step;
    }
}

TEST(EnergyWatch, TheLimitOfStopHolds) {
    SceneBuilder small = thrown(0.04);
    small.model().engine.energy_limit = 0.01;
    const End end = run(small);
    EXPECT_NE(end.stop.find("more than 0.01 times"), std::string::npos) << end.stop;
    SceneBuilder wide = thrown(0.2);
    wide.model().engine.energy_limit = 1e6;
    EXPECT_EQ(run(wide).stop, "");
}

// A node that penetrates when its interface starts brings energy along: it is no energy from nowhere.
TEST(EnergyWatch, PenetrationAtTheStartIsPutIn) {
    SceneBuilder small = over_a_square({{0, 0, 0.1}});  // 0.4 deep: 80
    small.hold(0);
    small.time_steps(1e-3, 0.3);
    small.model().engine.energy_limit = 0.05;
    EXPECT_EQ(run(small).stop, "");
    small.card().tstart.value = 0.1;
    EXPECT_EQ(run(small).stop, "") << "also where the interface starts later";
}

// Nothing can become unstable where everything is driven, whatever the step.
TEST(StepWatch, DrivenScenesHaveNoLimit) {
    SceneBuilder small = over_a_square({{0, 0, 0.6}});
    small.hold(small.blank_node(0));
    small.fix(0, {true, true, false, true, true, true});
    small.drive(0, 2, 1.0);
    small.time_steps(0.1, 0.5);
    const End end = run(small);
    EXPECT_EQ(end.stop, "");
    EXPECT_TRUE(end.warnings.empty());
}

TEST(StepWatch, OneWarningWithACount) {
    SceneBuilder small = thrown(0.05);
    small.model().engine.energy_limit = 1e30;
    const End end = run(small);
    ASSERT_EQ(end.warnings.size(), 1U);
    EXPECT_NE(end.warnings[0].find("of " + std::to_string(end.cycles) + " cycles"), std::string::npos)
        << end.warnings[0];
    EXPECT_NE(end.warnings[0].find("1.12 times"), std::string::npos) << "0.05 / 0.0447";
}

/// What is said of a step and an end before a run.
Problem judged(double step, double end, double interval = 0) {
    SceneBuilder small = thrown(step);
    small.model().engine.end_time = end;
    small.model().engine.history_interval = interval;
    if (interval > 0) small.model().engine.first_step.reset();
    Problems problems;
    check_runnable(small.scene(), problems);
    EXPECT_LE(problems.list().size(), 1U);
    return problems.list().empty() ? Problem{} : problems.list()[0];
}

TEST(StepWatch, ATimeThatStandsStillIsAnErrorBeforeTheFirstCycle) {
    for (const double step : {5e-324, 1e-25, 1e-17}) {
        const Problem p = judged(step, 1.0);
        EXPECT_EQ(p.severity, Severity::error) << step;
        EXPECT_EQ(p.card, "/DTIX");
        EXPECT_NE(p.rule.find("t + dt = t"), std::string::npos) << p.rule;
        EXPECT_NE(p.rule.find("cycles"), std::string::npos) << p.rule;
    }
    EXPECT_NE(judged(5e-324, 1.0).rule.find("more than 1e308 cycles"), std::string::npos) << "the quotient overflows";
    EXPECT_NE(judged(1e-14, 1.0).rule.find("asks for 100000000000000 cycles"), std::string::npos);
    EXPECT_EQ(judged(1.0, 1.0, 1e-20).card, "/TFILE") << "the interval bounds the step";
}

TEST(StepWatch, ManyCyclesAreAWarningAndTheUsualNumberIsNone) {
    const Problem p = judged(1e-9, 1.0);
    EXPECT_EQ(p.severity, Severity::warning);
    EXPECT_NE(p.rule.find("asks for 1000000000 cycles"), std::string::npos) << p.rule;
    EXPECT_EQ(judged(1e-7, 1.0).rule, "");
}

TEST(StepWatch, OwnStepsThatNeverArriveStopTheRun) {
    SceneBuilder small = over_a_square({{0, 0, 0.4}});
    small.hold(0);
    Model& model = small.model();
    model.engine.first_step.reset();
    model.engine.largest_step.reset();
    for (double& mass : model.nodal_mass)
        mass = 1e-40;
    const End end = run(small);
    EXPECT_EQ(end.cycles, 0);
    EXPECT_NE(end.stop.find("more cycles to the end"), std::string::npos) << end.stop;
}

TEST(Finite, WhatTheDeckGivesIsCheckedBeforeTheRun) {
    const auto refused = [](const std::function<void(SceneBuilder&)>& spoil) {
        SceneBuilder small = thrown(0.04);
        spoil(small);
        Problems problems;
        check_runnable(small.scene(), problems);
        return problems.error_count() == 1 ? problems.list()[0].rule : std::string("not refused");
    };
    constexpr double infinite = std::numeric_limits<double>::infinity();
    EXPECT_NE(refused([](SceneBuilder& s) { s.model().nodal_mass.back() = 1e300; }).find("mass of a node"),
              std::string::npos);
    EXPECT_NE(refused([](SceneBuilder& s) { s.card().secondary.element_stiffness[0] = infinite; }).find("stiffness"),
              std::string::npos);
    EXPECT_NE(refused([](SceneBuilder& s) { s.model().rigid_bodies[0].mass = 1e200; }).find("mass and inertia"),
              std::string::npos);
    EXPECT_NE(refused([](SceneBuilder& s) { s.model().nodes.position[1].x() = 1e150; }).find("position"),
              std::string::npos);
}

TEST(Finite, WhatGrowsInTheRunStopsItByName) {
    const auto stop = [](const std::function<void(SceneBuilder&)>& spoil) {
        SceneBuilder small = thrown(1e-3);
        spoil(small);
        const End end = run(small);
        return end.stop;
    };
    const std::string velocity = stop([](SceneBuilder& s) { s.model().initial_velocities[0].velocity.x() = 1e120; });
    EXPECT_NE(velocity.find("the velocity of node 100005 is (1e+120"), std::string::npos) << velocity;
    EXPECT_NE(velocity.find("in cycle 0 at t = 0"), std::string::npos) << velocity;
    const std::string load = stop([](SceneBuilder& s) { s.load(s.blank_node(0), 1, 1e300); });
    EXPECT_NE(load.find("the acceleration of node 100005"), std::string::npos) << load;
    const std::string tool = stop([](SceneBuilder& s) {
        s.model().boundary_conditions.clear();
        s.load(0, 4, 1e300);
    });
    EXPECT_NE(tool.find("node 900"), std::string::npos) << tool;
}

}  // namespace
}  // namespace type21::watches
