// Units of the card: unit_ID or the input units of /BEGIN, by the dimension of each field.
#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/model.h"

namespace type21::test {
namespace {

TEST(InterfaceUnits, UnitIdConvertsByDimension) {
    // Deck in Mg mm s, card in kg m s. 1 m = 1000 mm; 1 Pa = 1e-6 MPa; 1 N/m = 1e-3 N/mm (Mg/s^2); s and pure numbers
    // stay.
    Model model = blank_over_tool();
    model.unit_ids[3] = {1.0, 1.0, 1.0, "kg", "m", "s"};
    Problems problems;
    const Interface it = resolve_card(model,
                                      card_text({{"Igap", "1"},
                                                 {"Istf", "1"},
                                                 {"Gapmax", "0.008"},
                                                 {"DEPTH", "0.0035"},
                                                 {"Gapmin", "2e-4"},
                                                 {"Stfac", "2e6"},
                                                 {"Pskid", "3e7"},
                                                 {"Tstart", "0.5"},
                                                 {"Tstop", "0.7"},
                                                 {"Fric", "0.1"},
                                                 {"Fscalegap", "1.1"}},
                                                "/INTER/TYPE21/1/3"),
                                      problems);
    EXPECT_EQ(problems.error_count(), 0);
    EXPECT_DOUBLE_EQ(it.gapmax, 8.0);
    EXPECT_DOUBLE_EQ(it.depth, 3.5);
    EXPECT_DOUBLE_EQ(it.gapmin, 0.2);
    EXPECT_DOUBLE_EQ(it.stfac, 2e3);
    EXPECT_DOUBLE_EQ(it.pskid, 30.0);
    EXPECT_DOUBLE_EQ(it.tstart, 0.5);
    EXPECT_DOUBLE_EQ(it.tstop, 0.7);
    EXPECT_EQ(it.fric, 0.1);
    EXPECT_EQ(it.fscalegap, 1.1);
    EXPECT_DOUBLE_EQ(it.ascalek, 1e-6) << "the default is one Pa, the pressure unit of the card";
}

TEST(InterfaceUnits, StfacOfIstf0AndItsBounds) {
    Model model = blank_over_tool();
    model.unit_ids[3] = {1.0, 1.0, 1.0, "kg", "m", "s"};
    Problems problems;
    const Interface it = resolve_card(
        model, card_text({{"Stfac", "0.5"}, {"Stmin", "1e3"}, {"Stmax", "1e6"}}, "/INTER/TYPE21/1/3"), problems);
    EXPECT_EQ(it.stfac, 0.5) << "a pure number for Istf 0";
    EXPECT_DOUBLE_EQ(it.stmin, 1.0);
    EXPECT_DOUBLE_EQ(it.stmax, 1e3);
}

TEST(InterfaceUnits, HeatConvertsByDimension) {
    // 1 W/(m^2 K) = 1e-3 Mg/(s^3 K); W is kg m^2/s^3, so a coefficient has no length; m = 1000 mm; 1 Pa = 1e-6 MPa.
    Model model = thermal_blank_over_tool();
    model.unit_ids[3] = {1.0, 1.0, 1.0, "kg", "m", "s"};
    const auto card = [&](Fields fields) {
        fields.merge(
            Fields{{"Ithe", "1"}, {"Frad", "5.67e-8"}, {"Drad", "0.004"}, {"AscaleK", "2e6"}, {"Tint", "900.0"}});
        Problems problems;
        model.interfaces.clear();
        const Interface it = resolve_card(model, card_text(fields, "/INTER/TYPE21/1/3"), problems);
        EXPECT_EQ(problems.error_count(), 0);
        return it;
    };
    const Interface it = card({{"Kthe", "2e4"}});
    EXPECT_DOUBLE_EQ(it.kthe, 20.0);
    EXPECT_DOUBLE_EQ(it.frad, 5.67e-11);
    EXPECT_DOUBLE_EQ(it.drad, 4.0);
    EXPECT_DOUBLE_EQ(it.ascalek, 2.0);
    EXPECT_EQ(it.tint, 900.0);
    EXPECT_DOUBLE_EQ(card({{"Kthe", "2e4"}, {"fct_IDK", "3"}}).kthe, 20.0) << "also as the scale of a function";
    model.as_built.set(Departure::D38);
    EXPECT_DOUBLE_EQ(card({{"Kthe", "2e4"}, {"fct_IDK", "3"}}).kthe, 2e4) << "D38: the number as written";
    EXPECT_DOUBLE_EQ(card({{"Kthe", "2e4"}}).kthe, 20.0) << "with the function only";
    model.as_built.set(Departure::D36);
    EXPECT_DOUBLE_EQ(card({{"fct_IDK", "3"}}).kthe, 1e-3) << "D36: one W/(m^2 K), the unit of the card";
}

TEST(InterfaceUnits, XfreqIsAFrequencyOfIfiltr3Only) {
    Model model = blank_over_tool();
    model.input_units = {1e3, 1e-3, 1e-3, "Mg", "mm", "ms"};
    const auto xfreq = [&](const std::string& ifiltr) {
        Problems problems;
        model.interfaces.clear();
        return resolve_fields(model, {{"Fric", "0.1"}, {"Ifiltr", ifiltr}, {"Xfreq", "0.5"}}, problems).xfreq.value;
    };
    EXPECT_EQ(xfreq("1"), 0.5);
    EXPECT_EQ(xfreq("2"), 0.5);
    EXPECT_DOUBLE_EQ(xfreq("3"), 500.0) << "1/ms in 1/s";
}

TEST(InterfaceUnits, InputUnitsOfBeginHoldWithoutUnitId) {
    Model model = blank_over_tool();
    model.input_units = {1.0, 1.0, 1e-3, "kg", "m", "ms"};
    Problems problems;
    const Interface it = resolve_fields(model, {{"Gapmin", "0.002"}, {"Tstop", "4.0"}}, problems);
    EXPECT_DOUBLE_EQ(it.gapmin, 2.0);
    EXPECT_DOUBLE_EQ(it.tstop, 4e-3);
}

TEST(InterfaceUnits, AnUnknownUnitIdIsAnError) {
    Model model = blank_over_tool();
    Problems problems;
    resolve_card(model, card_text({}, "/INTER/TYPE21/1/4"), problems);
    EXPECT_EQ(problems.error_count(), 1);
}

}  // namespace
}  // namespace type21::test
