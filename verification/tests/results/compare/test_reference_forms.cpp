/// @file What the headers of other programs are taken for, and the hints on a difference.
#include <cmath>

#include <gtest/gtest.h>

#include "verification/results/compare/column_units.h"
#include "verification/results/compare/compare_file.h"
#include "verification/results/compare/comparison_text.h"
#include "verification/results/compare/header_name.h"
#include "verification/results/compare/hints.h"
#include "verification/tests/results/compare/tables.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

/// A run with interfaces 1 and 7, nodes 12 and 15, body 3; in Mg, mm, s.
struct SmallRun {
    test::TempFolder folder;
    SmallRun() {
        folder.write("run.json",
                     R"({"units": {"mass": "Mg", "length": "mm", "time": "s"},
                         "interfaces": [{"id": 1, "title": "punch"}, {"id": 7, "title": "die"}]})");
        folder.write("interface_1.csv", "time,FNX,FNZ\n0,0,0\n1,0,2\n2,0,6\n");
        folder.write("interface_7.csv", "time,FNX,FNZ\n0,0,0\n1,1,-2\n2,3,-6\n");
        folder.write("nodes.csv", "time,node,DX,VX\n0,12,0,1\n0,15,0,2\n1,12,1,1\n1,15,2,2\n2,12,2,1\n2,15,4,2\n");
        folder.write("rbody.csv", "time,rbody,DX\n0,3,0\n1,3,1\n2,3,2\n");
    }
    FolderComparison compare(const std::string& name, const std::string& text,
                             const FolderOptions& options = {}) const {
        const test::TempFolder reference;
        return compare_file(folder.path(), reference.write(name, text), options);
    }
};

std::string place(const std::string& header) {
    const SmallRun small;
    RunTables run(small.folder.path());
    const auto found = place_of_header(header, run);
    if (!found) return "";
    return fmt::format("{} {} {}", found->file, found->object.value_or(0), found->column);
}

TEST(HeaderName, IdTitleAndVariable) {
    for (const char* header :
         {"INTER 1 punch FNX", "1 punch FNX", "interface_1_FNX", "INTER1 fnx", "FNX (1)", "FNX 1",
          "INTER 1 tool 7 of 9 FNX", "TH/INTER 1 : FNX", "punch FNX", "1   punch            var 1"})
        EXPECT_EQ(place(header), "interface_1.csv 0 FNX") << header;
    EXPECT_EQ(place("INTER 7 die |FNX|"), "interface_7.csv 0 |FNX|");
    EXPECT_EQ(place("7 die CE_ELAST"), "interface_7.csv 0 CE_ELAST");
    EXPECT_EQ(place("9 other FNX"), "interface_9.csv 0 FNX") << "an id that the run does not have";
    for (const char* header :
         {"NODE 12 DX", "12 edge DX", "node_12.DX", "DX node 12", "12 group 3 DX", "NODE 12 var 1"})
        EXPECT_EQ(place(header), "nodes.csv 12 DX") << header;
    EXPECT_EQ(place("RBODY 3 punch DX"), "rbody.csv 3 DX");
    EXPECT_EQ(place("3 punch DX"), "rbody.csv 3 DX") << "no node has that id";
    for (const char* header : {"INTERNAL ENERGY", "X-MOMENTUM", "1 sheet IE", "DX", "FNX", "", "time step"})
        EXPECT_EQ(place(header), "") << header;
}

TEST(ColumnUnits, ProductsAndQuotients) {
    const auto is = [](const char* text, Dimension dimension, double si) {
        const auto unit = unit_of(text);
        return unit && unit->dimension == dimension && std::abs(unit->si / si - 1) < 1e-14;
    };
    constexpr Dimension impulse{1, 1, -1, 0};
    EXPECT_TRUE(is("kN s", impulse, 1e3));
    EXPECT_TRUE(is("N*ms", impulse, 1e-3));
    EXPECT_TRUE(is("N.s", impulse, 1));
    EXPECT_TRUE(is("Mg mm/s", impulse, 1));
    EXPECT_TRUE(is("mm/ms", dim::velocity, 1));
    EXPECT_TRUE(is("m s^-1", dim::velocity, 1));
    EXPECT_TRUE(is("mm/s2", {0, 1, -2, 0}, 1e-3));
    EXPECT_TRUE(is("kg/(m s^2)", dim::pressure, 1));
    EXPECT_TRUE(is("rad/ms", dim::frequency, 1e3));
    EXPECT_TRUE(is("\xC2\xB5s", dim::time, 1e-6));
    EXPECT_TRUE(is("mJ", dim::energy, 1e-3));
    for (const char* text : {"", "\xC2\xB0", "degC", "furlong", "%", "7", "N s kips"})
        EXPECT_FALSE(unit_of(text)) << text;
}

TEST(CompareFile, OneTableOfAllHistories) {
    const SmallRun run;
    const std::string table =
        "\"time\",\"INTERNAL ENERGY\",\"1 punch FNZ\",\"7 die FNX\",\"7 die FNZ\",\"NODE 12 DX\",\"NODE 15 DX\"\n"
        "0,9,0,0,0,0,0\n2,9,6,3,-6,2,4\n";
    const FolderComparison good = run.compare("allT01.csv", table);
    EXPECT_TRUE(good.ok()) << to_text(good);
    EXPECT_EQ(good.files.size(), 3U);
    EXPECT_NE(to_text(good).find("1 column left out"), std::string::npos);
    std::string changed = table;
    changed.replace(changed.rfind(",4"), 2, ",5");
    const FolderComparison bad = run.compare("allT01.csv", changed);
    ASSERT_TRUE(bad.first());
    EXPECT_EQ(bad.first()->difference.object, 15);
    EXPECT_EQ(bad.first()->column, "DX");
}

TEST(CompareFile, AColumnTwiceIsAnErrorOnlyWithOtherValues) {
    const SmallRun run;
    EXPECT_TRUE(run.compare("a.csv", "time,1 punch FNZ,INTER 1 punch FNZ\n0,0,0\n2,6,6\n").ok());
    EXPECT_THROW(run.compare("a.csv", "time,1 punch FNZ,INTER 1 punch FNZ\n0,0,0\n2,6,7\n"), CsvError);
}

TEST(CompareFile, UnitsOfTheHeaderAreConvertedAndSaid) {
    const SmallRun run;
    const FolderComparison good = run.compare("interface_1.csv", "time [ms];FNZ [kN s]\n0;0\n1000;0,002\n2000;0,006\n");
    EXPECT_TRUE(good.ok()) << to_text(good);
    EXPECT_NE(to_text(good).find("the times are in ms, ours in s: multiplied by 0.001"), std::string::npos);
    EXPECT_NE(to_text(good).find("FNZ: the reference is in kN s, ours in N s: multiplied by 1000"), std::string::npos);
    const FolderComparison force = run.compare("interface_1.csv", "time [s],FNZ [N]\n0,0\n1,2\n2,6\n");
    EXPECT_NE(to_text(force).find("such as a force where ours is an impulse"), std::string::npos) << to_text(force);
    const FolderComparison odd = run.compare("interface_1.csv", "time [ticks],FNZ\n0,0\n1,2\n2,6\n");
    EXPECT_TRUE(odd.ok());
    EXPECT_NE(to_text(odd).find("[ticks] of the times is not understood"), std::string::npos);
}

TEST(CompareFile, OptionsRenameAndScale) {
    const SmallRun run;
    FolderOptions options;
    options.changes.map = {{"time", "t"}, {"interface_7:FNX", "Force 1 [kN s]"}, {"node_15:DX", "u"}};
    const std::string table = "t,Force 1 [kN s],u\n0,0,0\n1,0.001,2\n2,0.003,4\n";
    EXPECT_TRUE(run.compare("a.csv", table, options).ok()) << to_text(run.compare("a.csv", table, options));
    options.changes.scale = {{"DX", 2.0}};
    EXPECT_FALSE(run.compare("a.csv", table, options).ok());
    options.changes.scale = {{"DZ", 2.0}};
    EXPECT_THROW(run.compare("a.csv", table, options), WrongOption);
    options.changes.scale.clear();
    options.changes.map[1].first = "interface_7:FNY";
    EXPECT_THROW(run.compare("a.csv", table, options), WrongOption);
    options.changes.map[1] = {"interface_7:FNX", "Force 2"};
    EXPECT_THROW(run.compare("a.csv", table, options), WrongOption);
    options.changes.map[1] = {"interface7:FNX", "Force 1"};
    EXPECT_THROW(run.compare("a.csv", table, options), WrongOption);
}

TEST(CompareFile, AShorterReferenceIsNoDifferenceAndAShorterRunIsOne) {
    const SmallRun run;
    const FolderComparison shorter = run.compare("interface_1.csv", "time,FNZ\n0,0\n1,2\n");
    EXPECT_TRUE(shorter.ok()) << to_text(shorter);
    EXPECT_NE(to_text(shorter).find("50 % of the time of ours"), std::string::npos);
    const std::string longer = "time,FNZ\n0,0\n1,2\n2,6\n3,7\n";
    EXPECT_FALSE(run.compare("interface_1.csv", longer).ok());
    FolderOptions options;
    options.until = 2;
    EXPECT_TRUE(run.compare("interface_1.csv", longer, options).ok());
    EXPECT_FALSE(run.compare("interface_1.csv", "time,FNZ\n5,0\n6,2\n").ok()) << "no time in common";
}

TEST(CompareFile, SmallBySymmetryIsNoDifference) {
    const SmallRun run;
    EXPECT_TRUE(run.compare("interface_1.csv", "time,FNX,FNZ\n0,0,0\n1,3e-10,2\n2,-1e-10,6\n").ok());
    EXPECT_FALSE(run.compare("interface_1.csv", "time,FNX,FNZ\n0,0,0\n1,3e-8,2\n2,-1e-8,6\n").ok());
}

std::string hint(const std::vector<double>& ours, const std::vector<double>& reference) {
    std::vector<double> time(ours.size());
    for (size_t i = 0; i < time.size(); ++i)
        time[i] = 1e-3 * static_cast<double>(i);
    return hint_on_values({"FNZ", time, ours, reference});
}

TEST(Hints, UnitsSignsAndRates) {
    const std::vector<double> ours{0, 1, 4, 9, 16, 25, 36};
    const auto times = [&](double factor) {
        std::vector<double> out = ours;
        for (double& value : out)
            value *= factor;
        return out;
    };
    EXPECT_NE(hint(ours, times(1e-3)).find("--scale COLUMN=1000 "), std::string::npos) << hint(ours, times(1e-3));
    EXPECT_NE(hint(ours, times(1e6)).find("--scale COLUMN=1e-6 "), std::string::npos);
    EXPECT_NE(hint(ours, times(-1)).find("opposite"), std::string::npos);
    EXPECT_NE(hint(ours, times(-1e3)).find("--scale COLUMN=-1e-3 "), std::string::npos);
    EXPECT_NE(hint(ours, times(2)).find("0.5 times"), std::string::npos);
    EXPECT_EQ(hint(ours, times(1 + 1e-6)), "") << "no unit, no sign";
    EXPECT_EQ(hint(ours, {0, 7, 1, -3, 2, 8, 5}), "");
    std::vector<double> rate;
    for (size_t i = 0; i < ours.size(); ++i)
        rate.push_back(2e3 * static_cast<double>(i));
    EXPECT_NE(hint(ours, rate).find("rate of ours, such as a force where ours is an impulse"), std::string::npos);
    for (double& value : rate)
        value *= -1e-3;
    EXPECT_NE(hint(ours, rate).find("over time times -1000 is ours"), std::string::npos) << hint(ours, rate);
}

TEST(Hints, IdsAndTimes) {
    EXPECT_EQ(hint_on_ids({1, 2}, {2, 3}), "");
    EXPECT_NE(hint_on_ids({1001, 1002}, {1, 2}).find("each of ours is 1000 more"), std::string::npos);
    EXPECT_EQ(hint_on_ids({1001, 1003}, {1, 2}).find("each of ours"), std::string::npos);
    EXPECT_NE(hint_on_times({0, 4e-3}, {0, 4}).find("--time-scale 1e-3"), std::string::npos);
    EXPECT_EQ(hint_on_times({0, 4}, {0, 2}), "");
    HintList list;
    list.add("FNX", "a");
    list.add("FNZ", "a");
    list.add("FNY", "");
    EXPECT_EQ(list.lines(), (std::vector<std::string>{"FNX, FNZ: a"}));
}

}  // namespace
}  // namespace type21
