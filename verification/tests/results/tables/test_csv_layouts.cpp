/// @file Tables as other programs write them.
#include <cmath>

#include <gtest/gtest.h>

#include "verification/results/tables/csv_number.h"
#include "verification/results/tables/csv_table.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

CsvTable table_of(const std::string& text, const CsvReading& reading = {}) {
    test::TempFolder folder;
    return read_csv(folder.write("x.csv", text), reading);
}

std::string complaint_about(const std::string& text) {
    try {
        table_of(text);
    } catch (const CsvError& error) {
        return error.what();
    }
    return "";
}

/// Time 0 and 1 with FNX 1.5 and -2.5.
void expect_two_rows(const std::string& text) {
    SCOPED_TRACE(text);
    const CsvTable table = table_of(text);
    EXPECT_EQ(table.columns, (std::vector<std::string>{"FNX"}));
    EXPECT_EQ(table.time, (std::vector<double>{0, 1}));
    ASSERT_EQ(table.values.size(), 1U);
    EXPECT_EQ(table.values[0], (std::vector<double>{1.5, -2.5}));
}

TEST(CsvLayouts, QuotesSeparatorsAndLineEnds) {
    expect_two_rows("\"time\",\"FNX\"\n0,1.5\n1,-2.5\n");
    expect_two_rows("\"time\",\"FNX\"\n\"0\",\"1.5\"\n\"1\",\"-2.5\"");
    expect_two_rows("\xEF\xBB\xBFtime;FNX\r\n0;1.5\r\n1;-2.5\r\n");
    expect_two_rows("time\tFNX\n0\t1.5\n1\t-2.5\n");
    expect_two_rows("time,FNX\r0,1.5\r1,-2.5\r");
    expect_two_rows("\"time\" ; \"FNX\"\n 0 ; 1.5\n1;-2.5\n");
    expect_two_rows("sep=;\ntime;FNX\n0;1.5\n1;-2.5\n");
    expect_two_rows("time,FNX,\n0,1.5,\n1,-2.5,\n");
}

TEST(CsvLayouts, CommentsBlankLinesAndIndexColumns) {
    expect_two_rows("# made by a solver\n\ntime,FNX\n# units s, N s\n0,1.5\n\n  \n1,-2.5\n# end\n");
    expect_two_rows("# a run\n# time,FNX\n# of 2026\n0,1.5\n1,-2.5\n");
    expect_two_rows(",time,FNX\n0,0,1.5\n1,1,-2.5\n");
}

TEST(CsvLayouts, DecimalCommas) {
    expect_two_rows("time;FNX\n0,0;1,5\n1,0;-2,5\n");
    expect_two_rows("time\tFNX\n0,0\t1,5E+00\n1,0\t-2,5\n");
    EXPECT_NE(complaint_about("time;FNX\n0.5;1,5\n").find("decimal points (line 2) beside commas in numbers (line 2)"),
              std::string::npos);
    EXPECT_NE(complaint_about("time;FNX\n0;1,500\n1;2,500\n").find("cannot be told"), std::string::npos);
    EXPECT_EQ(complaint_about("time;FNX\n0;0,001\n1;2,500\n"), "") << "0,001 is no thousand";
    EXPECT_NE(complaint_about("time,FNX\n0,5,1,5\n").find("needs ';' between its cells"), std::string::npos);
    EXPECT_NE(complaint_about("time;FNX\n0;1,234,567\n").find("'1,234,567' is not a number"), std::string::npos);
}

TEST(CsvLayouts, UnitsAreTakenOffTheNames) {
    for (const char* header : {"time [ms];FNX [N s];note", "Time (ms);FNX (N s);note", "TIME / ms;FNX / N s;note"}) {
        const CsvTable table = table_of(std::string(header) + "\n0;1;2\n");
        EXPECT_EQ(table.columns, (std::vector<std::string>{"FNX", "note"})) << header;
        EXPECT_EQ(table.time_unit, "ms") << header;
        EXPECT_EQ(table.unit(0), "N s") << header;
        EXPECT_EQ(table.unit(1), "") << header;
    }
    EXPECT_EQ(name_and_unit("FNX (1)").name, "FNX (1)") << "an id is no unit";
    EXPECT_EQ(name_and_unit("||FN||").name, "||FN||");
}

TEST(CsvLayouts, AnotherNameOfTheTimesMayBeGiven) {
    EXPECT_EQ(table_of("Zeit,FNX\n0,1\n", {"Zeit", true}).rows(), 1U);
    EXPECT_NE(complaint_about("Zeit,FNX\n0,1\n").find(":1: the first column must be 'time'; it is 'Zeit'"),
              std::string::npos);
}

TEST(CsvLayouts, DamagedTextsAreRefusedWithTheirLine) {
    EXPECT_NE(complaint_about("time,FNX\n0,\"1\n1,2\n").find("x.csv:2: a quote is not closed"), std::string::npos);
    EXPECT_NE(complaint_about("time,FNX\n0,\"1\"2\n").find("x.csv:2: text behind a closing quote"), std::string::npos);
    EXPECT_NE(complaint_about(std::string("time,FNX\n0,\0\n", 13)).find("a NUL"), std::string::npos);
    EXPECT_NE(complaint_about(std::string("\xFF\xFEt\0", 4)).find("is UTF-16"), std::string::npos);
    EXPECT_NE(complaint_about("time,FNX\n0,1e999\n").find("'1e999' is not a number"), std::string::npos);
    EXPECT_NE(complaint_about("time,node,DX\n0,1.5,0\n").find("node '1.5' is not an id"), std::string::npos);
    EXPECT_NE(complaint_about("time,node,DX\n0,1e30,0\n").find("is not an id"), std::string::npos);
    const std::string escape = complaint_about("time,FNX\n0,\x1b[2J" + std::string(5000, 'x') + "\n");
    EXPECT_EQ(escape.find('\x1b'), std::string::npos);
    EXPECT_LT(escape.size(), 200U);
    EXPECT_NE(complaint_about("# only\n\n").find("is empty"), std::string::npos);
}

TEST(CsvLayouts, ACellMayHoldSeparatorsQuotesAndLineEnds) {
    const std::string header = "time,\"a, \"\"b\"\"\nc\",\"d\"\"\"\n";
    const CsvTable table = table_of(header + "0,1,2\n");
    EXPECT_EQ(table.columns, (std::vector<std::string>{"a, \"b\"\\x0ac", "d\""}));
    EXPECT_NE(complaint_about(header + "0,1,x\n").find("x.csv:3: 'x' is not a number"), std::string::npos)
        << "lines are counted inside quotes, too";
}

TEST(CsvNumber, FormsOfANumber) {
    CsvNumbers numbers(false);
    EXPECT_EQ(numbers.read("1.5D-3", 1), 1.5e-3);
    EXPECT_EQ(numbers.read("+2.5E+02", 1), 250.0);
    EXPECT_EQ(numbers.read("1e-400", 1), 0.0);
    EXPECT_EQ(numbers.read("1,5", 1), std::nullopt);
    EXPECT_EQ(numbers.read("0x1p3", 1), std::nullopt);
    EXPECT_EQ(numbers.read("", 1), std::nullopt);
    EXPECT_EQ(numbers.read("1.5.2", 1), std::nullopt);
}

/// Printed with seven digits: the reference is off by half a unit of the last.
TEST(CsvNumber, TheDigitsOfATableTellItsRounding) {
    EXPECT_NEAR(table_of("time,FNX\n0,1.234567e+00\n1,-9.876543e-03\n").rounding, 0.5e-6, 1e-20);
    EXPECT_EQ(table_of("time,FNX\n0,1.234567e+00\n1,-9.876543e-03\n").rounded_to, "7 digits");
    EXPECT_EQ(table_of("time,FNX\n0,1.5\n1,-2.25\n").rounding, 0) << "a short table of exact numbers";
    EXPECT_EQ(table_of("time,FNX\n0,0.33333333333333331\n1,2.5e+00\n").rounding, 0) << "all 17 digits";
    std::string general = "time,FNX\n";
    for (int i = 1; i < 40; ++i)
        general += fmt::format("{},{:.6g}\n", i, std::sqrt(i));
    EXPECT_NEAR(table_of(general).rounding, 0.5e-5, 1e-19);
}

}  // namespace
}  // namespace type21
