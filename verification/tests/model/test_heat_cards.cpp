// /HEAT/MAT, /INITEMP, /IMPTEMP and the lumped heat capacity.
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;

std::string heat_card(const std::vector<std::string>& first, const std::vector<std::string>& second = {},
                      const std::string& id = "1") {
    return "/HEAT/MAT/" + id + "\n" + reals(first) + (second.empty() ? "\n" : reals(second));
}

const std::vector<std::string> steel{"300.0", "3.6", "50.0", "0.02"};

TEST(HeatMaterial, MakesItsMaterialThermal) {
    const Resolved r = resolved(with_cards(heat_card(steel, {"1e20", "0.0", "0.0", "0.0"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_TRUE(r.model.materials[0].heat.has_value());
    const HeatMaterial& heat = *r.model.materials[0].heat;
    EXPECT_EQ(heat.initial_temperature, 300);
    EXPECT_EQ(heat.heat_capacity, 3.6);
    EXPECT_EQ(heat.conductivity_a, 50);
    EXPECT_EQ(heat.conductivity_b, 0.02);
    EXPECT_FALSE(r.model.materials[1].heat.has_value());
}

TEST(HeatMaterial, ConvertsByDimension) {
    // J/(m^3 K) = 1e-6 mJ/(mm^3 K); W/(m K) = 1 mW/(mm K) in Mg mm s (N mm/s = mW).
    const std::string unit = "/UNIT/5\nSI\n" + reals({"kg", "m", "s"});
    const Resolved r = resolved(with_cards(unit + heat_card({"300.0", "3.6e6", "50.0", "0.02"}, {}, "1/5")));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.materials[0].heat->initial_temperature, 300);
    EXPECT_DOUBLE_EQ(r.model.materials[0].heat->heat_capacity, 3.6);
    EXPECT_DOUBLE_EQ(r.model.materials[0].heat->conductivity_a, 50);
    EXPECT_DOUBLE_EQ(r.model.materials[0].heat->conductivity_b, 0.02);
}

TEST(HeatMaterial, MistakesAreNamed) {
    const auto field = [](const std::vector<std::string>& first, const std::string& id = "1") {
        const Problem p = only(resolved(with_cards(heat_card(first, {}, id))).problems);
        EXPECT_EQ(p.severity, Severity::error);
        return p.field;
    };
    EXPECT_EQ(field({"300.0", "0.0", "50.0"}), "rho_Cp");
    EXPECT_EQ(field({"300.0", "-3.6", "50.0"}), "rho_Cp");
    EXPECT_EQ(field({"300.0", "3.6", "-50.0"}), "A_S");
    EXPECT_EQ(field({"-3.0", "3.6", "50.0"}), "T0");
    EXPECT_EQ(field(steel, "66"), "mat_ID");
    const Problem twice = only(resolved(with_cards(heat_card(steel) + heat_card(steel))).problems);
    EXPECT_NE(twice.rule.find("taken"), std::string::npos);
    EXPECT_EQ(only(resolved(with_cards(heat_card({"300.0", "0.0", "50.0"}))).problems).value, "0 Mg/(mm s^2 K)");
}

TEST(HeatMaterial, WhatIsNotUsedIsAWarning) {
    const auto note = [](const std::vector<std::string>& second) {
        const Problem p = only(resolved(with_cards(heat_card(steel, second))).problems);
        EXPECT_EQ(p.severity, Severity::warning);
        return p;
    };
    EXPECT_EQ(note({"1500.0", "40.0"}).field, "A_L");
    EXPECT_NE(note({"1500.0", "40.0"}).rule.find("A_S + B_S T"), std::string::npos);
    EXPECT_EQ(note({"1500.0", "0.0", "0.01"}).field, "B_L");
    EXPECT_EQ(note({"", "", "", "0.9"}).field, "EFRAC");
    EXPECT_TRUE(resolved(with_cards(heat_card(steel, {"1e20", "40.0"}))).problems.list().empty()) << "never molten";
    EXPECT_TRUE(resolved(with_cards(heat_card(steel, {"1500.0"}))).problems.list().empty()) << "nothing above it";
    const Problem zero = only(resolved(with_cards(heat_card({"", "3.6", "50.0"}))).problems);
    EXPECT_EQ(zero.severity, Severity::warning);
    EXPECT_EQ(zero.field, "T0");
}

TEST(HeatMaterial, OldDecksNameTheirFormulation) {
    const auto problems = [](const std::string& version, const std::string& iform) {
        std::string card = heat_card(steel);
        card.insert(card.size() - 2, fmt::format("{:>10}", iform));
        return resolved(replaced(with_cards(card), "      2025         0", fmt::format("{:>10}         0", version)))
            .problems;
    };
    EXPECT_TRUE(problems("2021", "1").list().empty()) << all_of(problems("2021", "1"));
    EXPECT_EQ(only(problems("2021", "0")).severity, Severity::warning);
    EXPECT_EQ(only(problems("2021", "2")).severity, Severity::error);
    EXPECT_EQ(only(problems("2021", "2")).field, "Iform");
    EXPECT_TRUE(problems("2022", "2").list().empty()) << "no such field from 2022 on";
}

TEST(HeatCapacity, HasTheSharesOfTheMass) {
    // Quad 10 x 10 x 1.5: 150 mm^3 x 3.6 = 540 mJ/K, 135 a node. Triangle (2 5 3), right angle at 2, 75 mm^3: 270 mJ/K,
    // half of it at node 2, a quarter at 5 and at 3.
    const Resolved r = resolved(with_cards(heat_card(steel)));
    const std::vector<double>& c = r.model.nodal_heat_capacity;
    ASSERT_EQ(c.size(), r.model.nodal_mass.size());
    EXPECT_DOUBLE_EQ(c[0], 135);
    EXPECT_DOUBLE_EQ(c[1], 135 + 135);
    EXPECT_DOUBLE_EQ(c[2], 135 + 67.5);
    EXPECT_DOUBLE_EQ(c[3], 135);
    EXPECT_DOUBLE_EQ(c[4], 67.5);
    EXPECT_EQ(c[5], 0) << "the tool's material is not thermal";
    for (size_t node = 0; node < 5; ++node)
        EXPECT_DOUBLE_EQ(c[node] / r.model.nodal_mass[node], 3.6 / 7.8e-9);
}

TEST(HeatCapacity, VoidMaterialCounts) {
    // Tool quad 30 x 20 x 1: 600 mm^3 x 2 = 1200 mJ/K, 300 a node.
    const Resolved r = resolved(with_cards(heat_card({"900.0", "2.0", "1e-9"}, {}, "2")));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.nodal_heat_capacity.at(0), 0);
    EXPECT_DOUBLE_EQ(r.model.nodal_heat_capacity.at(5), 300);
}

TEST(HeatCapacity, IsEmptyWithoutThermalMaterial) {
    EXPECT_TRUE(resolved(driven_scene()).model.nodal_heat_capacity.empty());
}

TEST(InitialTemperature, OfAGroup) {
    const auto card = [](const std::string& temperature, const std::string& type) {
        return fmt::format("/INITEMP/1\nhot\n{:>20}{:>10}{:>10}\n", temperature, 2, type);
    };
    const Resolved r = resolved(with_cards(card("900.0", "0")));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.initial_temperatures.size(), 1U);
    EXPECT_EQ(r.model.initial_temperatures[0].temperature, 900);
    EXPECT_EQ(r.model.groups[static_cast<size_t>(r.model.initial_temperatures[0].group)].id, 2);
    EXPECT_EQ(only(resolved(with_cards(card("900.0", "1"))).problems).field, "fld_type");
    EXPECT_EQ(only(resolved(with_cards(card("-1.0", "0"))).problems).field, "T0");
    EXPECT_EQ(only(resolved(with_cards("/INITEMP/1\nhot\n" + reals({"900.0"}))).problems).field, "grnod_ID");
}

TEST(ImposedTemperature, WithAllItsFields) {
    const std::string sensor = "/SENSOR/TIME/4\ns\n" + reals({"1e-4"});
    const Resolved r = resolved(
        with_cards(sensor + "/IMPTEMP/1\nheat\n" + ints({"1", "4", "2"}) + reals({"2.0", "900.0", "0.1", "0.2"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const ImposedTemperature& t = r.model.imposed_temperatures.at(0);
    EXPECT_EQ(t.function, 0);
    EXPECT_EQ(t.sensor, 0);
    EXPECT_EQ(r.model.groups[static_cast<size_t>(t.group)].id, 2);
    EXPECT_EQ(t.scale_x, 2);
    EXPECT_EQ(t.scale_y, 900);
    EXPECT_EQ(t.start, 0.1);
    EXPECT_EQ(t.stop, 0.2);
    const Resolved blank = resolved(with_cards("/IMPTEMP/1\nheat\n" + ints({"1", "0", "2"}) + "\n"));
    EXPECT_EQ(blank.model.imposed_temperatures.at(0).scale_y, 1);
    EXPECT_EQ(blank.model.imposed_temperatures[0].stop, 1e30);
    EXPECT_EQ(blank.model.imposed_temperatures[0].sensor, -1);
    EXPECT_EQ(only(resolved(with_cards("/IMPTEMP/1\nheat\n" + ints({"66", "0", "2"}) + "\n")).problems).field,
              "fct_IDT");
}

}  // namespace
}  // namespace type21
