#include <cmath>

#include <gtest/gtest.h>

#include "verification/results/tables/csv_table.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::TempFolder;
using test::write_text;

std::string message(const std::string& text) {
    TempFolder folder;
    write_text(folder / "x.csv", text);
    try {
        read_csv(folder / "x.csv");
    } catch (const CsvError& error) {
        return error.what();
    }
    return "";
}

TEST(CsvTable, ReadsEveryFormOfANumber) {
    TempFolder folder;
    write_text(folder / "x.csv", "time,node,DX,TEMP\r\n0.0,7, 1e-3 ,+2.5E+02\r\n1E-6,9,-0,.5\r\n2e-6,9,nan,-inf\r\n");
    const CsvTable table = read_csv(folder / "x.csv");
    EXPECT_TRUE(table.has_object);
    EXPECT_EQ(table.columns, (std::vector<std::string>{"DX", "TEMP"}));
    EXPECT_EQ(table.time, (std::vector<double>{0, 1e-6, 2e-6}));
    EXPECT_EQ(table.object, (std::vector<Id>{7, 9, 9}));
    EXPECT_EQ(table.values[0][0], 1e-3);
    EXPECT_EQ(table.values[1][0], 250.0);
    EXPECT_EQ(table.values[1][1], 0.5);
    EXPECT_TRUE(std::isnan(table.values[0][2]));
    EXPECT_EQ(table.values[1][2], -INFINITY);
}

TEST(CsvTable, SaysWhereARowIsWrong) {
    EXPECT_NE(message("time,FNX\n0,1\n1,x\n").find("x.csv:3: 'x' is not a number"), std::string::npos);
    EXPECT_NE(message("time,FNX\n0,\n").find("x.csv:2: '' is not a number"), std::string::npos);
    EXPECT_NE(message("time,FNX\n0,1,2\n").find("x.csv:2: 3 cells where the header has 2"), std::string::npos);
    EXPECT_NE(message("time,FNX\nnan,1\n").find("x.csv:2: time nan is not finite"), std::string::npos);
    EXPECT_NE(message("time,FNX\n0,1e\n").find("x.csv:2"), std::string::npos);
    EXPECT_NE(message("t,FNX\n0,1\n").find("must be 'time'"), std::string::npos);
    EXPECT_NE(message("time,FNX,FNX\n0,1,1\n").find("'FNX' is there twice"), std::string::npos);
    EXPECT_NE(message("").find("is empty"), std::string::npos);
    EXPECT_THROW(read_csv("/no/such/file.csv"), CsvError);
    EXPECT_EQ(message("time,FNX\n"), "");
}

TEST(CsvTable, FiltersByTimeAndNode) {
    TempFolder folder;
    write_text(folder / "x.csv", "time,node,DX\n0,7,1\n0,9,2\n1,7,3\n1,9,4\n2,9,5\n");
    const CsvTable table = filtered(read_csv(folder / "x.csv"), {1, 2}, {9});
    EXPECT_EQ(table.values[0], (std::vector<double>{4, 5}));
    EXPECT_EQ(filtered(table, {}, {}).rows(), 2U);
}

}  // namespace
}  // namespace type21
