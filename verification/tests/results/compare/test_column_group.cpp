#include <cmath>

#include <gtest/gtest.h>

#include "verification/results/compare/column_group.h"
#include "verification/tests/results/compare/tables.h"

namespace type21 {
namespace {

TEST(ColumnGroup, EveryColumnOfAHistoryHasTheGroupOfItsUnit) {
    for (const char* name : {"FNX", "FTZ", "|FNX|", "|FZ|", "||FN||", "||F||", "FY"})
        EXPECT_EQ(unit_group(name), "impulse") << name;
    for (const char* name : {"QFRIC", "CE_ELAST", "CE_FRIC", "CE_DAMP"})
        EXPECT_EQ(unit_group(name), "energy") << name;
    for (const char* name : {"DX", "DZ", "X", "Y"})
        EXPECT_EQ(unit_group(name), "length") << name;
    EXPECT_EQ(unit_group("VX"), "velocity");
    EXPECT_EQ(unit_group("VRX"), "angular velocity");
    EXPECT_EQ(unit_group("AZ"), "acceleration");
    EXPECT_EQ(unit_group("REACX"), "reaction");
    EXPECT_EQ(unit_group("REACXX"), "reaction moment");
    EXPECT_EQ(unit_group("MZ"), "moment impulse");
    EXPECT_EQ(unit_group("TEMP"), "TEMP");
}

TEST(ColumnScale, IsTheLargestValueOrAThousandthOfTheGroup) {
    const CsvTable table = test::history(
        {0, 1}, {{"FNX", {1, -8}}, {"FNY", {1e-12, 0}}, {"||F||", {0, 5}}, {"CE_FRIC", {0, 0}}, {"TEMP", {NAN, 300}}});
    const std::vector<double> scales = column_scales(table, table, 1e-9);
    EXPECT_EQ(scales[0], 8);
    EXPECT_EQ(scales[1], 8) << "1e-12 beside 8 is nothing at 1e-9";
    EXPECT_EQ(scales[2], 5);
    EXPECT_EQ(scales[3], 0);
    EXPECT_EQ(scales[4], 300);
}

TEST(ColumnScale, AComponentThatIsNothingInBothHistoriesHasTheScaleOfItsVector) {
    const auto with = [](double fny) { return test::history({0, 1}, {{"FNX", {0, 8}}, {"FNY", {0, fny}}}); };
    EXPECT_EQ(column_scales(with(7e-9), with(-7e-9), 1e-9)[1], 8);
    EXPECT_EQ(column_scales(with(7e-9), with(9e-9), 1e-9)[1], 1e-3 * 8) << "ours has a force there";
    EXPECT_EQ(column_scales(with(9e-9), with(0), 1e-9)[1], 1e-3 * 8) << "the reference has a force there";
    EXPECT_EQ(column_scales(with(1e-3), with(0), 0.5)[1], 8) << "a thousandth of the vector";
    EXPECT_EQ(column_scales(with(1), with(1), 0.5)[1], 1) << "is no rounding, however wide the tolerance";
}

}  // namespace
}  // namespace type21
