// Ithe, lines 10 and 11, and what they ask of the materials.
#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/model.h"

namespace type21::test {
namespace {

constexpr auto error = Severity::error;
constexpr auto warning = Severity::warning;

Fields hot(Fields fields) {
    fields.merge(Fields{{"Ithe", "1"}, {"Kthe", "20.0"}, {"Tint", "900.0"}});
    return fields;
}

Problems problems_of(const Fields& fields, Model model = thermal_blank_over_tool()) {
    Problems problems;
    resolve_fields(model, fields, problems);
    return problems;
}

/// Without errors; the warnings go to `notes`.
Interface with(const Fields& fields, const std::vector<Departure>& departures, Problems& notes,
               Model model = thermal_blank_over_tool()) {
    for (const Departure departure : departures)
        model.as_built.set(departure);
    const Interface it = resolve_fields(model, fields, notes);
    EXPECT_EQ(notes.error_count(), 0) << to_text(notes.list().front());
    return it;
}

Interface with(const Fields& fields, const std::vector<Departure>& departures = {}) {
    Problems notes;
    return with(fields, departures, notes);
}

TEST(HeatRules, ACleanCardHasNoProblem) {
    EXPECT_TRUE(problems_of(hot({})).list().empty());
    EXPECT_TRUE(problems_of(hot({{"fct_IDK", "3"},
                                 {"AscaleK", "2.0"},
                                 {"Frad", "1e-9"},
                                 {"Drad", "4.0"},
                                 {"Fcond", "4"},
                                 {"Dcond", "3.0"}}))
                    .list()
                    .empty());
}

struct Wrong {
    const char* name;
    Fields fields;
    const char* field;
    const char* words;
};

class HeatField : public testing::TestWithParam<Wrong> {};

TEST_P(HeatField, IsOneError) {
    const Problems problems = problems_of(hot(GetParam().fields));
    const auto errors = about(problems, GetParam().field, error);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(problems.error_count(), 1);
    EXPECT_NE(errors[0].rule.find(GetParam().words), std::string::npos) << errors[0].rule;
    EXPECT_FALSE(errors[0].value.empty());
    EXPECT_FALSE(errors[0].remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, HeatField,
    testing::Values(Wrong{"ithe", {{"Ithe", "3"}}, "Ithe", "one of 0, 1, 2"},
                    Wrong{"ithe_form", {{"Ithe_form", "2"}}, "Ithe_form", "one of 0, 1"},
                    Wrong{"kthe", {{"Kthe", "-1.0"}}, "Kthe", "negative"},
                    Wrong{"frad", {{"Frad", "-1.0"}}, "Frad", "negative"},
                    Wrong{"drad", {{"Frad", "1.0"}, {"Drad", "-1.0"}}, "Drad", "negative"},
                    Wrong{"fheat", {{"Fheat", "-1.0"}}, "Fheat", "negative"},
                    Wrong{"dcond", {{"Fcond", "4"}, {"Dcond", "-1.0"}}, "Dcond", "negative"},
                    Wrong{"tint", {{"Tint", "-1.0"}}, "Tint", "absolute"},
                    Wrong{"fct_idk", {{"fct_IDK", "13"}}, "fct_IDK", "no /FUNCT"},
                    Wrong{"fcond", {{"Fcond", "13"}}, "Fcond", "no /FUNCT"},
                    Wrong{"fcond_ordinate", {{"Fcond", "3"}, {"Dcond", "2.0"}}, "Fcond", "between 0 and 1"}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

class IdleHeatField : public testing::TestWithParam<Wrong> {};

TEST_P(IdleHeatField, IsAWarning) {
    const Problems problems = problems_of(hot(GetParam().fields));
    EXPECT_EQ(problems.error_count(), 0) << to_text(problems.list().front());
    const auto notes = about(problems, GetParam().field, warning);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].rule.find(GetParam().words), std::string::npos) << notes[0].rule;
}

INSTANTIATE_TEST_SUITE_P(
    All, IdleHeatField,
    testing::Values(Wrong{"tint_form1", {{"Ithe_form", "1"}}, "Tint", "temperatures of its nodes"},
                    Wrong{"tint_ithe2", {{"Ithe", "2"}}, "Tint", "temperatures of its nodes"},
                    Wrong{"tint_0", {{"Tint", "0.0"}}, "Tint", "absolute zero"},
                    Wrong{"ascalek", {{"AscaleK", "2.0"}}, "AscaleK", "fct_IDK is 0"},
                    Wrong{"drad", {{"Drad", "2.0"}}, "Drad", "Frad is 0"},
                    Wrong{"dcond", {{"Dcond", "2.0"}}, "Dcond", "Fcond is 0"},
                    Wrong{"fheat_no_friction", {{"Fheat", "0.9"}}, "Fheat", "no friction"},
                    Wrong{"fheat_above_1", {{"Fric", "0.1"}, {"Fheat", "1.1"}}, "Fheat", "above 1"},
                    Wrong{"kthe_0", {{"Kthe", "0.0"}, {"fct_IDK", "3"}}, "Kthe", "no heat is conducted"},
                    Wrong{"fcond_kthe_0", {{"Kthe", "0.0"}, {"Fcond", "4"}, {"Frad", "1e-9"}}, "Fcond", "Kthe is 0"},
                    Wrong{"nothing", {{"Kthe", "0.0"}}, "Ithe", "no heat is exchanged"},
                    Wrong{"far", {{"Frad", "1e-9"}, {"Drad", "10.5"}}, "Drad", "shortest secondary edge 10 mm"}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

// @manual field Ithe, fct_IDK, Fcond
TEST(HeatRules, FunctionsAreLinkedOnlyWithIthe) {
    const Interface it = with(hot({{"fct_IDK", "3"}, {"Fcond", "4"}, {"Dcond", "2.0"}}));
    EXPECT_EQ(it.function_conduction, 0);
    EXPECT_EQ(it.function_distance, 1);
    const Interface cold = with({{"fct_IDK", "3"}, {"Fcond", "4"}, {"Dcond", "2.0"}});
    EXPECT_EQ(cold.function_conduction, -1);
    EXPECT_EQ(cold.function_distance, -1);
    EXPECT_EQ(cold.fct_idk, 0);
    EXPECT_EQ(cold.fcond, 0);
}

// @manual field Fcond; comment 22
TEST(HeatRules, AbscissaeOfFcondAreJudgedToo) {
    Model model = thermal_blank_over_tool();
    model.functions[1].x = {0.0, 1.5};
    const auto errors = about(problems_of(hot({{"Fcond", "4"}}), model), "Fcond", error);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].value, "4 (X = 1.5)");
}

// @manual field Kthe; departure D36
TEST(HeatRules, KtheOfAFunctionIsZeroOnThePageAndOneAsBuilt) {
    EXPECT_EQ(with(hot({{"Kthe", "0.0"}, {"fct_IDK", "3"}})).kthe, 0.0);
    Problems notes;
    const Interface built = with(hot({{"Kthe", "0.0"}, {"fct_IDK", "3"}}), {Departure::D36}, notes);
    EXPECT_EQ(built.kthe, 1.0);
    EXPECT_NE(built.kthe.origin.why.find("D36"), std::string::npos);
    EXPECT_TRUE(about(notes, "Kthe", warning).empty());
    EXPECT_EQ(with(hot({{"Kthe", "0.0"}}), {Departure::D36}).kthe, 0.0) << "without a function 0 stays";
}

// ---- distances: gap 0.6 (Igap 0), shortest edge 10

TEST(HeatDistances, NothingReachesBeyondTheGapWithoutRadiationAndFcond) {
    const Interface it = with(hot({{"Drad", "4.0"}, {"Dcond", "3.0"}}));
    EXPECT_EQ(it.drad, 0.0);
    EXPECT_EQ(it.dcond, 0.0);
    EXPECT_EQ(it.drad.origin.kind, Origin::Kind::rule);
}

// @manual field Drad; comment 17
TEST(HeatDistances, DradDefaultIsTheLargerOfGapAndEdge) {
    EXPECT_EQ(with(hot({{"Frad", "1e-9"}})).drad, 10.0);
    EXPECT_EQ(with(hot({{"Frad", "1e-9"}, {"Gapmin", "12.0"}})).drad, 12.0);
    EXPECT_EQ(with(hot({{"Frad", "1e-9"}, {"Drad", "4.0"}})).drad, 4.0);
    EXPECT_EQ(with(hot({{"Frad", "1e-9"}, {"Drad", "0.1"}})).drad, 0.6) << "raised to the largest gap";
}

// @manual field Drad, Dcond; comment 24
TEST(HeatDistances, OfConductionBeyondTheGap) {
    // Fcond without Frad: Drad follows Dcond.
    const Interface it = with(hot({{"Fcond", "4"}, {"Dcond", "3.0"}, {"Drad", "7.0"}}));
    EXPECT_EQ(it.drad, 3.0);
    EXPECT_EQ(it.dcond, 3.0);
    // Frad without Drad: the same (manual page, comment 23).
    EXPECT_EQ(with(hot({{"Frad", "1e-9"}, {"Fcond", "4"}, {"Dcond", "3.0"}})).drad, 3.0);
    // Neither: both are Drad's default.
    const Interface none = with(hot({{"Fcond", "4"}}));
    EXPECT_EQ(none.drad, 10.0);
    EXPECT_EQ(none.dcond, 10.0);
    const Interface drad = with(hot({{"Frad", "1e-9"}, {"Fcond", "4"}, {"Drad", "1.5"}}));
    EXPECT_EQ(drad.dcond, 1.5) << "Dcond 0: Drad";
}

// @manual field Dcond
TEST(HeatDistances, DcondIsAtMostDrad) {
    Problems notes;
    const Interface it = with(hot({{"Frad", "1e-9"}, {"Drad", "2.0"}, {"Fcond", "4"}, {"Dcond", "3.0"}}), {}, notes);
    EXPECT_EQ(it.dcond, 2.0);
    ASSERT_EQ(about(notes, "Dcond", warning).size(), 1u);
    EXPECT_EQ(about(notes, "Dcond", warning)[0].value, "3 mm");
}

// @manual comment 24; departure D14
TEST(HeatDistances, D14LeavesDcondAtZero) {
    const Interface it = with(hot({{"Frad", "1e-9"}, {"Fcond", "4"}, {"Drad", "1.5"}}), {Departure::D14});
    EXPECT_EQ(it.dcond, 0.0);
    EXPECT_NE(it.dcond.origin.why.find("D14"), std::string::npos);
}

// @manual departure D11
TEST(HeatDistances, D11SetsDradWithoutRadiationToo) {
    EXPECT_EQ(with(hot({}), {Departure::D11}).drad, 10.0);
    EXPECT_EQ(with(hot({{"Drad", "4.0"}}), {Departure::D11}).drad, 10.0) << "Frad 0 puts it to 0 before";
    EXPECT_EQ(with({{"Drad", "4.0"}}, {Departure::D11}).drad, 0.0) << "not without Ithe";
}

// ---- materials

TEST(ThermalSides, ASecondaryNodeWithoutHeatCapacityIsNamed) {
    for (const std::string ithe : {"1", "2"}) {
        Model model = thermal_blank_over_tool();
        model.nodal_heat_capacity[4] = 0;
        const auto errors =
            about(problems_of({{"Ithe", ithe}, {"Kthe", "2.0"}, {"Tint", "9.0"}}, model), "Ithe", error);
        ASSERT_EQ(errors.size(), 1u);
        EXPECT_EQ(errors[0].value, "1 nodes: 1005");
        EXPECT_NE(errors[0].remedy.find("/HEAT/MAT"), std::string::npos);
    }
}

TEST(ThermalSides, WithoutAnyThermalMaterialAllAreNamed) {
    const auto errors = about(problems_of(hot({}), blank_over_tool()), "Ithe", error);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].value, "9 nodes: 1001, 1002, 1003, 1004, 1005 and 4 more");
}

Model cold_tool() {
    Model model = thermal_blank_over_tool();
    for (size_t node = 9; node < 13; ++node)
        model.nodal_heat_capacity[node] = 0;
    model.groups.push_back({7, "", {9, 10, 11, 12}});
    model.groups.push_back({8, "", {9, 10}});
    return model;
}

TEST(ThermalSides, IthewithConstantToolAsksNothingOfIt) {
    EXPECT_TRUE(problems_of(hot({}), cold_tool()).list().empty());
}

// @manual field Ithe_form
TEST(ThermalSides, IthFormOneNeedsCapacityOrImposedTemperatureOfTheTool) {
    const Fields fields{{"Ithe", "1"}, {"Ithe_form", "1"}, {"Kthe", "2.0"}};
    Model model = cold_tool();
    const auto all = about(problems_of(fields, model), "Ithe_form", error);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].value, "4 nodes: 2001, 2002, 2003, 2004");
    model.initial_temperatures.push_back({1, 900.0, 0});
    EXPECT_EQ(problems_of(fields, model).error_count(), 1) << "a temperature of time 0 holds no heat";
    ImposedTemperature imposed;
    imposed.group = 1;
    model.imposed_temperatures.push_back(imposed);
    const auto half = about(problems_of(fields, model), "Ithe_form", error);
    ASSERT_EQ(half.size(), 1u);
    EXPECT_EQ(half[0].value, "2 nodes: 2003, 2004");
    model.imposed_temperatures[0].group = 0;
    EXPECT_EQ(problems_of(fields, model).error_count(), 0);
    EXPECT_EQ(problems_of(fields).error_count(), 0) << "or a heat capacity";
}

TEST(ThermalSides, IthetwoNeedsATemperatureOfTheTool) {
    const Fields fields{{"Ithe", "2"}, {"Kthe", "2.0"}};
    Model model = cold_tool();
    ASSERT_EQ(about(problems_of(fields, model), "Ithe", error).size(), 1u);
    model.initial_temperatures.push_back({1, 900.0, 0});
    EXPECT_EQ(problems_of(fields, model).error_count(), 0);
    model.initial_temperatures.clear();
    ImposedTemperature imposed;
    imposed.group = 0;
    model.imposed_temperatures.push_back(imposed);
    EXPECT_EQ(problems_of(fields, model).error_count(), 0);
    EXPECT_EQ(problems_of(fields).error_count(), 0) << "or that of its thermal material";
}

}  // namespace
}  // namespace type21::test
