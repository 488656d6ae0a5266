// Heat between blank and tool: the conductances by hand, cooling and radiation against solutions of their own.
#include <cmath>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gtest/gtest.h>

#include "reference/as_built/d15_d16_d32_heat.h"
#include "reference/contact/heat_exchange.h"
#include "reference/cycle/contact.h"
#include "reference/model/model.h"
#include "small_scene.h"

namespace type21::reference {
namespace {

using test::over_a_square;

// @manual eq 14; field Kthe; comment 16
TEST(Heat, ConductanceIsASeriesOfSheetAndContact) {
    EXPECT_DOUBLE_EQ(conduction_conductance(20, 0.0, 50), 20);
    EXPECT_DOUBLE_EQ(conduction_conductance(20, 0.5, 50), 1 / (0.01 + 0.05));
    EXPECT_EQ(conduction_conductance(0, 0.5, 50), 0.0);
}

// @manual eq 20; field Fcond, Dcond; comment 22; departure D32
TEST(Heat, DistanceScalesTheCoefficientInSeriesWithTheSheet) {
    EXPECT_DOUBLE_EQ(distance_conductance(20, 0.5, 0.5, 50), 1 / (0.01 + 0.1));
    EXPECT_DOUBLE_EQ(as_built::distance_conductance(20, 0.5, 0.5, 50), 0.5 / (0.01 + 0.05));
    EXPECT_EQ(distance_conductance(20, 0.0, 0.5, 50), 0.0);
}

// @manual eq 17; field Frad; comment 17
TEST(Heat, RadiationIsTheDifferenceOfFourthPowers) {
    EXPECT_NEAR(radiated(5.67e-8, 900, 300), 5.67e-8 * (std::pow(900.0, 4) - std::pow(300.0, 4)), 1e-8);
    EXPECT_EQ(radiated(5.67e-8, 300, 300), 0.0);
}

// @manual eq 16; field Drad, Dcond; comment 17, 23; departure D15
TEST(Heat, Zones) {
    Interface card;
    card.frad.value = 1;
    card.drad.value = 2.0;
    card.function_distance = 0;
    card.dcond.value = 1.0;
    EXPECT_TRUE(heat_zones(card, 0.5, 0.5).conduction);
    const HeatZones near = heat_zones(card, 0.9, 0.5);
    EXPECT_TRUE(!near.conduction && near.distance && near.radiation);
    const HeatZones far = heat_zones(card, 2.0, 0.5);
    EXPECT_TRUE(!far.distance && far.radiation);
    EXPECT_FALSE(heat_zones(card, 2.1, 0.5).any());
    EXPECT_TRUE(as_built::heat_zones(card, 2.1, 0.5).radiation);
}

/// A node at a height over the square, made thermal by one shell; T_s 300, tool 500 unless the tool has temperatures.
struct Hot {
    explicit Hot(double height) : small(over_a_square({{0.2, 0.1, height}})) {
        Model& model = small.model();
        Interface& card = small.card();
        card.ithe.value = 1;
        card.kthe.value = 20;
        card.tint.value = 500;
        card.ascalek.value = 1;
        card.secondary.area[0] = 4;
        model.materials.resize(1);
        model.materials[0].heat = HeatMaterial{300, 0.036, 50, 0.02};
        model.parts.resize(1);
        model.parts[0].material = 0;
        const int node = small.blank_node(0);
        model.shells.push_back({1, {node, node, node, node}, 0, 1.0});
        // A shell needs an area to weigh its conductivity with: three more nodes that nothing else uses.
        for (int j = 1; j < 4; ++j) {
            model.nodes.id.push_back(9000 + j);
            model.nodes.position.push_back(model.nodes.position[static_cast<size_t>(node)] +
                                           Vec3(j != 3 ? 1 : 0, j != 1 ? 1 : 0, 0));
            model.nodes.line.push_back(0);
            model.shells[0].node[static_cast<size_t>(j)] = model.nodes.size() - 1;
        }
        temperature.assign(static_cast<size_t>(model.nodes.size()), 300.0);
    }

    /// One cycle; `last` is the whole step.
    NodeHeat cycle(Contact& contact, double time, double dt) {
        Motion motion;
        motion.time = time;
        motion.step = motion.friction_step = dt;
        motion.position = small.model().nodes.position;
        velocity.assign(small.model().nodes.position.size(), Vec3::Zero());
        motion.velocity = velocity;
        motion.temperature = temperature;
        motion.tools.resize(1);
        last = contact.step(motion);
        return last.heat[0];
    }
    double& blank() { return temperature[static_cast<size_t>(small.blank_node(0))]; }

    SceneBuilder small;
    std::vector<double> temperature;
    std::vector<Vec3> velocity;
    ContactStep last;
};

// Conduction at d = 0.3: Phi = A (T_m - T_s) dt / (d / (A_S + B_S T_s) + 1 / K)
// @manual field Ithe, Tint, Kthe; comment 16
TEST(Heat, OneCycleOfConduction) {
    Hot hot(0.3);
    Contact contact(hot.small.scene(), 0);
    const double expected = 4 * 200 * 1e-3 / (0.3 / (50 + 0.02 * 300) + 1 / 20.0);
    EXPECT_NEAR(hot.cycle(contact, 1e-3, 1e-3).heat, expected, 1e-12 * expected);
}

// f_K runs from 1 at 0 to 3 at 100. F_n = 1000 * 0.2 on A = 4 is the pressure 50; over AscaleK 2 it is 25: f_K = 1.5.
// D38: 2 * 50 = 100, f_K = 3.
// @manual eq 15; field Kthe, fct_IDK, AscaleK; comment 16; departure D38
TEST(Heat, TheExchangeCoefficientFollowsThePressure) {
    for (const bool d38 : {false, true}) {
        Hot hot(0.3);
        hot.small.card().ascalek.value = 2;
        hot.small.card().function_conduction = 0;
        hot.small.model().functions.push_back({1, "", {0.0, 100.0}, {1.0, 3.0}});
        hot.small.model().as_built.set(Departure::D38, d38);
        Contact contact(hot.small.scene(), 0);
        const double expected = 4 * 200 * 1e-3 / (0.3 / 56 + 1 / (d38 ? 60.0 : 30.0));
        EXPECT_NEAR(hot.cycle(contact, 0, 1e-3).heat, expected, 1e-12 * expected) << d38;
    }
}

// A h_r = 4 * 5.67e-8 (500^2 + 300^2)(500 + 300): with it Phi = A h_r (T_m - T_s) dt.
// @manual eq 17; field Frad
TEST(Heat, RadiationReportsWhatItConducts) {
    Hot hot(0.9);
    hot.small.card().frad.value = 5.67e-8;
    hot.small.card().drad.value = 1.5;
    Contact contact(hot.small.scene(), 0);
    const NodeHeat node = hot.cycle(contact, 1e-3, 1e-3);
    EXPECT_NEAR(node.radiant_conductance, 4 * 5.67e-8 * (250000 + 90000) * 800, 1e-12);
    EXPECT_NEAR(node.heat, node.radiant_conductance * 200 * 1e-3, 1e-15);
    EXPECT_EQ(node.conductance, 0);
}

// A node of capacity C cools by T_{n+1} = T_n + r (Tint - T_n): after n cycles the difference is (1 - r)^n of the
// first, and that approaches the exponential as the step shrinks.
TEST(Heat, CoolingFollowsItsRecursionAndTheExponential) {
    Hot hot(-0.1);  // d = max(delta, 0) = 0: conductance K, whatever the temperature
    Contact contact(hot.small.scene(), 0);
    const double capacity = 8;
    const double dt = 1e-4;
    const double rate = 4 * 20 / capacity;
    double difference = 200;
    for (int n = 1; n <= 1000; ++n) {
        hot.blank() += hot.cycle(contact, n * dt, dt).heat / capacity;
        difference *= 1 - rate * dt;
    }
    EXPECT_NEAR(500 - hot.blank(), difference, 1e-10);
    EXPECT_NEAR(500 - hot.blank(), 200 * std::exp(-rate * 0.1), 200 * rate * rate * 0.1 * dt);  // first order in dt
}

int radiation_ode(double, const double t[], double slope[], void* data) {
    const double* p = static_cast<const double*>(data);  // A Frad / C, T_m
    slope[0] = p[0] * (std::pow(p[1], 4) - std::pow(t[0], 4));
    return GSL_SUCCESS;
}

// Radiation only: the march converges to the solution of the ODE by an independent integrator (Runge-Kutta-Fehlberg
// 8(9)).
TEST(Heat, RadiationConvergesToItsOde) {
    double error[2];
    for (int level = 0; level < 2; ++level) {
        Hot hot(0.9);
        hot.small.card().frad.value = 5.67e-8;
        hot.small.card().drad.value = 1.5;
        Contact contact(hot.small.scene(), 0);
        const double dt = 1e-3 / (1 << level);
        const int steps = 100 << level;
        const double capacity = 8;
        for (int n = 1; n <= steps; ++n)
            hot.blank() += hot.cycle(contact, n * dt, dt).heat / capacity;
        double parameters[] = {4 * 5.67e-8 / capacity, 500};
        gsl_odeiv2_system system{radiation_ode, nullptr, 1, parameters};
        gsl_odeiv2_driver* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-4, 1e-11, 1e-11);
        double time = 0;
        double exact[] = {300};
        gsl_odeiv2_driver_apply(driver, &time, steps * dt, exact);
        gsl_odeiv2_driver_free(driver);
        EXPECT_GT(exact[0], 380);  // it has gone somewhere
        error[level] = std::abs(hot.blank() - exact[0]);
    }
    EXPECT_NEAR(error[0] / error[1], 2.0, 0.05);  // first order
}

// @manual field Ithe_form; comment 16; departure D16
TEST(Heat, WhatTheToolGivesTheBlankGets) {
    Hot hot(0.3);
    hot.small.card().ithe_form.value = 1;
    for (int n = 1; n <= 4; ++n)
        hot.temperature[static_cast<size_t>(n)] = 900;
    Contact contact(hot.small.scene(), 0);
    const NodeHeat node = hot.cycle(contact, 1e-3, 1e-3);
    EXPECT_GT(node.heat, 0);
    EXPECT_NEAR(hot.last.sums.heat_to_tool, -node.heat, 1e-13 * node.heat);
    EXPECT_NEAR(node.heat, 4 * 600 * 1e-3 / (0.3 / 56 + 0.05), 1e-10);  // T_m = 900, not Tint
}

// @manual field Ithe
TEST(Heat, WithoutItheNothingThermalIsThere) {
    SceneBuilder cold = over_a_square({{0.2, 0.1, 0.3}});
    for (const EffectMemory& memory : Contact(cold.scene(), 0).memory_by_effect())
        EXPECT_NE(memory.effect, Effect::heat);
    Hot hot(0.3);
    bool found = false;
    for (const EffectMemory& memory : Contact(hot.small.scene(), 0).memory_by_effect())
        found = found || memory.effect == Effect::heat;
    EXPECT_TRUE(found);
}

// Proximity exchanges heat only.
// @manual eq 16; comment 17
TEST(Heat, AProximityNodeHasNoForce) {
    Hot hot(0.9);
    hot.small.card().frad.value = 5.67e-8;
    hot.small.card().drad.value = 1.5;
    Contact contact(hot.small.scene(), 0);
    const NodeHeat node = hot.cycle(contact, 1e-3, 1e-3);
    EXPECT_EQ(hot.last.nodes[0].decision.kind, Kind::proximity);
    EXPECT_EQ(hot.last.nodes[0].force, Vec3(0, 0, 0));
    EXPECT_GT(node.heat, 0);
}

}  // namespace
}  // namespace type21::reference
