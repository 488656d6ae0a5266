// Heat and friction in the march: the thermal limit of the step, temperatures and friction laws that leave their range.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "../contact/small_scene.h"
#include "reference/cycle/contact.h"
#include "reference/host/effect_checks.h"
#include "reference/host/march.h"
#include "reference/host/thermal_limit.h"

namespace type21 {
namespace {

using test::over_a_square;

std::unique_ptr<ContactMethod> contact_of_reference(const Scene& scene, int interface) {
    return std::make_unique<reference::Contact>(scene, interface);
}

/// A square sheet of side 2 and thickness 1 over the square tool, k = 40, 0.3 above it (gap 0.5), Kthe 20 on an area of
/// 4 at each node. Heat capacities: blank 0.1, tool 0.01.
SceneBuilder warm_square(double kthe = 20) {
    SceneBuilder small = over_a_square({{-1, -1, 0.3}, {1, -1, 0.3}, {1, 1, 0.3}, {-1, 1, 0.3}});
    Material steel;
    steel.heat = HeatMaterial{900, 3.6, 40, 0};
    small.blank_shells({{0, 1, 2, 3}}, 1.0, steel);
    Interface& card = small.card();
    card.ithe.value = 1;
    card.kthe.value = kthe;
    card.tint.value = 300;
    card.secondary.area.assign(4, 4.0);
    Model& model = small.model();
    model.nodal_heat_capacity.assign(model.nodes.position.size(), 0.01);
    for (int i = 0; i < 4; ++i)
        model.nodal_heat_capacity[static_cast<size_t>(small.blank_node(i))] = 0.1;
    model.nodal_heat_capacity[static_cast<size_t>(small.main_node())] = 0;
    return small;
}

/// Contact of the first blank node, at the weights 1/2, 1/4, 1/4 of the first sub-triangle.
ContactStep touching(const NodeHeat& heat) {
    ContactStep step;
    step.active = true;
    step.nodes.resize(4);
    step.nodes[0].decision = {Kind::contact, 0, 1, 1, 0.25, 0.25, Stage::bounded};
    step.heat.resize(4);
    step.heat[0] = heat;
    return step;
}

double limit_of(const SceneBuilder& small, const NodeHeat& heat, double scale = 0.9) {
    return ThermalLimit(small.model())(HostState(small.model()), {touching(heat)}, scale).step;
}

// Sheet: B_i of a square of side 2 has the length 1/sqrt(8): K_11 = 40 * 4 / 8 = 20 = -K_13, K_12 = 0, so that G = 20.
// Contact: A Kthe = 80, or what it conducts now.
TEST(ThermalLimit, OfContactToolAndSheet) {
    EXPECT_NEAR(limit_of(warm_square(0), {}), 0.9 * 0.1 / 20, 1e-15) << "the sheet alone";
    EXPECT_NEAR(limit_of(warm_square(), {}), 0.9 * 0.1 / (80 + 20), 1e-15) << "a node that may touch";
    EXPECT_NEAR(limit_of(warm_square(), {0, 0, 150, 0}), 0.9 * 0.1 / (150 + 20), 1e-15) << "more than Kthe A";
    EXPECT_NEAR(limit_of(warm_square(0), {0, 0, 0, 50}), 0.9 * 0.1 / (50 + 20), 1e-15) << "radiation";
    EXPECT_NEAR(limit_of(warm_square(), {0, 0, 60, 0}, 0.002), 0.002 * 2 * 0.1 / 60, 1e-15) << "scaled, as built";
    // The tool's nodes have the shares 3/8, 3/8, 1/8, 1/8, and at least what one node brings to them: 80 on 0.01.
    SceneBuilder heated = warm_square();
    heated.card().ithe_form.value = 1;
    EXPECT_NEAR(limit_of(heated, {}), 0.9 * 0.01 / 80, 1e-15);
    EXPECT_NEAR(limit_of(heated, {0, 0, 400, 0}), 0.9 * 0.01 / (3 * 400 / 8.0), 1e-15);
}

// C = 0.1. Alone with a tool of constant temperature a node may take 2 C/G; where the other side changes too, C/G.
TEST(ThermalLimit, IsStableBeyondTheOwnStep) {
    const auto stable = [](SceneBuilder small, const NodeHeat& heat) {
        small.model().materials[0].heat->conductivity_a = 0;
        return ThermalLimit(small.model())(HostState(small.model()), {touching(heat)}, 0.9).stable;
    };
    EXPECT_NEAR(stable(warm_square(), {0, 0, 60, 0}), 2 * 0.1 / 60, 1e-15);
    EXPECT_NEAR(stable(warm_square(), {0, 0, 40, 20}), 2 * 0.1 / 60, 1e-15) << "radiation, too";
    EXPECT_TRUE(std::isinf(stable(warm_square(), {}))) << "what may touch later is no matter of this step";
    SceneBuilder heated = warm_square();
    heated.card().ithe_form.value = 1;
    EXPECT_NEAR(stable(heated, {0, 0, 60, 0}), 0.01 / (60 * 3 / 8.0), 1e-15) << "the node of the tool";
}

// f_K runs from 1 to 3: pressed as hard as its table knows, the node conducts A Kthe 3.
TEST(ThermalLimit, CountsTheHighestPointOfTheFunctionOfPressure) {
    SceneBuilder small = warm_square();
    small.card().function_conduction = static_cast<int>(small.model().functions.size());
    small.model().functions.push_back({1, "", {0.0, 100.0}, {1.0, 3.0}});
    EXPECT_NEAR(limit_of(small, {}), 0.9 * 0.1 / (240 + 20), 1e-15);
}

/// Smallest and largest temperature of all nodes that hold heat, over a run with its own time step.
std::pair<double, double> range_of(SceneBuilder small) {
    Model& model = small.model();
    model.engine.first_step.reset();
    model.engine.largest_step.reset();
    model.engine.history_interval = 0.02;
    model.engine.end_time = 0.3;
    std::pair<double, double> range{1e30, -1e30};
    march(small.scene(), contact_of_reference, [&](const CycleRecord& record) {
        for (size_t n = 0; n < record.temperature->size(); ++n) {
            if (!(model.nodal_heat_capacity[n] > 0)) continue;
            range.first = std::min(range.first, (*record.temperature)[n]);
            range.second = std::max(range.second, (*record.temperature)[n]);
        }
    });
    return range;
}

// A hot sheet at 900 over a tool at 300 that holds little heat, and a cold one at a corner: with a step of 2 C/G, or
// without the tool or the sheet in it, temperatures leave this range and grow.
// @manual field Ithe_form, Frad; comment 16, 17
TEST(ThermalLimit, TemperaturesStayBetweenThoseOfTheStart) {
    for (const bool radiates : {false, true}) {
        SceneBuilder small = warm_square(radiates ? 0 : 20);
        small.hold(small.main_node());
        for (int i = 0; i < 4; ++i)
            small.hold(small.blank_node(i));
        Interface& card = small.card();
        card.ithe_form.value = 1;
        if (radiates) {
            card.frad.value = 1e-8;
            card.drad.value = 2;
            card.secondary.gap.assign(4, 0.1);
            card.secondary.search_gap = card.secondary.gap;
        }
        Model& model = small.model();
        InitialTemperature cold;
        cold.temperature = 300;
        cold.group = static_cast<int>(model.groups.size());
        model.initial_temperatures.push_back(cold);
        model.groups.push_back({99, "", {1, 2, 3, 4, small.blank_node(2)}});
        const auto [low, high] = range_of(small);
        EXPECT_GE(low, 300 * (1 - 1e-12)) << radiates;
        EXPECT_LE(high, 900 * (1 + 1e-12)) << radiates;
        EXPECT_GT(high - low, 1);
    }
}

ImposedTemperature imposed(SceneBuilder& small, double value) {
    ImposedTemperature condition;
    condition.function = static_cast<int>(small.model().functions.size());
    small.model().functions.push_back({7, "", {0.0}, {value}});
    condition.group = static_cast<int>(small.model().groups.size());
    small.model().groups.push_back({98, "", {1, 2, 3, 4}});
    return condition;
}

TEST(EffectChecks, BelowAbsoluteZeroStopsTheRun) {
    SceneBuilder small = warm_square();
    HostState state(small.model());
    EXPECT_TRUE(absolute_temperatures(small.model()));
    EXPECT_NO_THROW(check_temperatures(small.model(), state, true));
    state.temperature[static_cast<size_t>(small.blank_node(1))] = -1;
    state.temperature[static_cast<size_t>(small.blank_node(2))] = -66.7;
    EXPECT_NO_THROW(check_temperatures(small.model(), state, false));
    try {
        check_temperatures(small.model(), state, true);
        FAIL();
    } catch (const RunStopped& stopped) {
        const std::string said = stopped.what();
        EXPECT_EQ(stopped.why, RunStopped::Why::diverged);
        EXPECT_NE(said.find("-66.7 K"), std::string::npos) << said;
        EXPECT_NE(said.find("node 100007"), std::string::npos) << said;
        EXPECT_NE(said.find("2 nodes"), std::string::npos) << said;
    }
}

TEST(EffectChecks, ADeckThatImposesLessThanZeroHasAnotherScale) {
    SceneBuilder small = warm_square();
    small.model().imposed_temperatures.push_back(imposed(small, 20));
    EXPECT_TRUE(absolute_temperatures(small.model()));
    small.model().imposed_temperatures.push_back(imposed(small, -20));
    EXPECT_FALSE(absolute_temperatures(small.model()));
    small.card().frad.value = 1e-11;
    EXPECT_TRUE(absolute_temperatures(small.model())) << "radiation needs the absolute scale";
}

// e^(C2 s) is beyond double at C2 s = 1000; C1 is not 0.
// @manual eq 11; field Ifric, C2; comment 13
TEST(March, AFrictionLawThatOverflowsStopsTheRun) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    small.hold(small.main_node());
    small.drive(small.blank_node(0), 0, 1000.0);
    small.drive(small.blank_node(0), 1, 0.0);
    small.drive(small.blank_node(0), 2, 0.0);
    Interface& card = small.card();
    card.ifric.value = 2;
    card.fric.value = 0.1;
    card.c[0].value = 0.5;
    card.c[1].value = 1;
    small.time_steps(1e-6, 1e-5);
    try {
        march(small.scene(), contact_of_reference, [](const CycleRecord&) {});
        FAIL();
    } catch (const RunStopped& stopped) {
        const std::string said = stopped.what();
        EXPECT_NE(said.find("C2 = 1 "), std::string::npos) << said;
        EXPECT_NE(said.find("sliding speed 1000 "), std::string::npos) << said;
        EXPECT_NE(said.find("node 100005"), std::string::npos) << said;
    }
    card.c[0].value = 0;
    EXPECT_NO_THROW(march(small.scene(), contact_of_reference, [](const CycleRecord&) {})) << "the term is 0";
}

// @manual field fct_IDF; departure D39
TEST(FrictionReport, FrictionBelowZeroIsOneWarning) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    Model& model = small.model();
    small.card().id = 11;
    small.card().fct_idf.value = 31;
    small.card().ascalef.value = 2;
    std::vector<std::string> said;
    MarchOptions options;
    options.warn = [&](const std::string& text) { said.push_back(text); };
    HostState state(model);
    ContactStep step;
    {
        FrictionReport report(model, state, options);
        report.note({step});
    }
    EXPECT_TRUE(said.empty());
    {
        FrictionReport report(model, state, options);
        state.cycle = 1;
        step.friction_below_zero = {3, small.blank_node(0), 820, -0.02};
        report.note({step});
        step.friction_below_zero = {2, small.blank_node(0), 900, -0.5};
        report.note({step});
        EXPECT_TRUE(said.empty()) << "at the end";
    }
    ASSERT_EQ(said.size(), 1U);
    for (const char* part : {"interface 11", "fct_IDF 31", "-0.02", "temperature 410", "node 100005", "cycle 1",
                             "5 times", "it is taken as 0"})
        EXPECT_NE(said[0].find(part), std::string::npos) << part << " in: " << said[0];
    model.as_built.set(Departure::D39);
    EXPECT_NE(warning_of(BelowZero{1, 0, 820, -0.02, 0, 0}, model, small.card()).find("D39"), std::string::npos);
}

}  // namespace
}  // namespace type21
