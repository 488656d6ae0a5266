// The table that `type21 check` prints.
#include <set>

#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/field_table.h"
#include "reference/model/interface_fields.h"
#include "reference/model/model.h"

namespace type21::test {
namespace {

FieldRow row_of(const std::vector<FieldRow>& rows, const std::string& name) {
    for (const FieldRow& row : rows)
        if (row.name == name) return row;
    ADD_FAILURE() << "no row " << name;
    return {};
}

std::vector<FieldRow> table(const Fields& fields) {
    Model model = blank_over_tool();
    Problems problems;
    const Interface it = resolve_fields(model, fields, problems);
    return field_table(it, model.units);
}

std::vector<FieldRow> thermal_table(const Fields& fields) {
    Model model = thermal_blank_over_tool();
    Problems problems;
    const Interface it = resolve_fields(model, fields, problems);
    return field_table(it, model.units);
}

TEST(FieldTable, HasEveryFieldOfTheTwelveLinesInOrder) {
    const auto rows = table({});
    // Fields a line: 8, 5, 3, 5, 4, 7, 5, 1, 3, 5, 5, 4.
    const std::vector<int> expected{8, 5, 3, 5, 4, 7, 5, 1, 3, 5, 5, 4};
    std::vector<int> counted(12, 0);
    int last = 1;
    std::set<std::string> names;
    for (const FieldRow& row : rows) {
        EXPECT_GE(row.card_line, last);
        last = row.card_line;
        ++counted.at(static_cast<size_t>(row.card_line) - 1);
        EXPECT_TRUE(names.insert(row.name).second) << row.name << " twice";
    }
    EXPECT_EQ(counted, expected);
}

TEST(FieldTable, UnitsAreThoseOfTheWorkUnits) {
    const auto rows = table({});
    EXPECT_EQ(row_of(rows, "Gapmin").unit, "mm");
    EXPECT_EQ(row_of(rows, "Tstop").unit, "s");
    EXPECT_EQ(row_of(rows, "Pmax").unit, "MPa");
    EXPECT_EQ(row_of(rows, "Stmax").unit, "N/mm");
    EXPECT_EQ(row_of(rows, "Tint").unit, "K");
    EXPECT_EQ(row_of(rows, "Angladm").unit, "deg");
    EXPECT_EQ(row_of(rows, "Fric").unit, "");
    EXPECT_EQ(row_of(rows, "Igap").unit, "");
    EXPECT_EQ(row_of(rows, "Stfac").unit, "") << "a factor with Istf 0";
    EXPECT_EQ(row_of(table({{"Istf", "1"}}), "Stfac").unit, "N/mm");
}

TEST(FieldTable, UnitsThatHangOnAFlag) {
    EXPECT_EQ(row_of(table({}), "Kthe").unit, "Mg/(s^3 K)") << "a coefficient";
    EXPECT_EQ(row_of(thermal_table({{"Ithe", "1"}, {"fct_IDK", "4"}}), "Kthe").unit, "Mg/(s^3 K)")
        << "also as the scale of a function";
    EXPECT_EQ(row_of(table({{"Ifiltr", "3"}, {"Xfreq", "9.0"}}), "Xfreq").unit, "1/s") << "a cutting frequency";
    EXPECT_EQ(row_of(table({{"Ifiltr", "1"}, {"Xfreq", "0.5"}}), "Xfreq").unit, "");
}

TEST(FieldTable, ValuesAreTheShortestThatReadBack) {
    const auto rows = table({{"Gapmin", "0.1"}, {"IBC", "011"}, {"Inacti", "5"}});
    EXPECT_EQ(row_of(rows, "Gapmin").value, "0.1");
    EXPECT_EQ(row_of(rows, "IBC").value, "011");
    EXPECT_EQ(row_of(rows, "Inacti").value, "5");
    EXPECT_EQ(row_of(rows, "Tstop").value, "1e+30");
    EXPECT_EQ(row_of(rows, "surf_IDm").value, "2");
}

TEST(FieldTable, OriginsStandBeside) {
    const auto rows = table({{"Gapmin", "0.1"}, {"Pmax", "5.0"}});
    EXPECT_EQ(to_text(row_of(rows, "Gapmin").origin), "line 12");
    EXPECT_EQ(to_text(row_of(rows, "VISs").origin), "default: 0 means 1");
    EXPECT_EQ(to_text(row_of(rows, "Pmax").origin), "rule (line 10): used with Igap 2 only");
}

TEST(FieldTable, FrictionCoefficientsHaveTheUnitsOfTheirLaw) {
    // Table 1 of the manual page, comment 13: law 1: 1/p, 1/v, 1/(pv), 1/p^2, 1/v^2; Renard: four pure numbers, two
    // velocities.
    Interface it;
    const auto dimension_of = [&](size_t rank) {
        for (const InterfaceField& field : interface_fields())
            if (const size_t* c = std::get_if<size_t>(&field.member); c != nullptr && *c == rank)
                return dimension(field, it);
        return Dimension{9, 9, 9, 9};
    };
    it.ifric.value = 1;
    EXPECT_EQ(dimension_of(0), (Dimension{-1, 1, 2, 0}));
    EXPECT_EQ(dimension_of(1), (Dimension{0, -1, 1, 0}));
    EXPECT_EQ(dimension_of(2), (Dimension{-1, 0, 3, 0}));
    EXPECT_EQ(dimension_of(3), (Dimension{-2, 2, 4, 0}));
    EXPECT_EQ(dimension_of(4), (Dimension{0, -2, 2, 0}));
    it.ifric.value = 2;
    EXPECT_EQ(dimension_of(0), (Dimension{-2, 2, 4, 0}));
    EXPECT_EQ(dimension_of(2), (Dimension{-1, 1, 2, 0}));
    EXPECT_EQ(dimension_of(4), dim::none);
    EXPECT_EQ(dimension_of(5), (Dimension{0, -1, 1, 0}));
    it.ifric.value = 3;
    EXPECT_EQ(dimension_of(3), dim::none);
    EXPECT_EQ(dimension_of(4), dim::velocity);
    EXPECT_EQ(dimension_of(5), dim::velocity);
    it.ifric.value = 4;
    EXPECT_EQ(dimension_of(0), dim::none);
    EXPECT_EQ(dimension_of(1), (Dimension{0, -1, 1, 0}));
}

}  // namespace
}  // namespace type21::test
