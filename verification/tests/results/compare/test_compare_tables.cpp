#include <cmath>

#include <gtest/gtest.h>

#include "verification/results/compare/compare_tables.h"
#include "verification/tests/results/compare/tables.h"

namespace type21 {
namespace {

using test::history;
using test::node_history;

TEST(CompareTables, FindsTheLargestDifferenceAndWhere) {
    const CsvTable reference = history({0, 1, 2}, {{"FNX", {0, 4, 8}}, {"FNY", {0, 0, 0}}});
    const CsvTable ours = history({0, 1, 2}, {{"FNX", {0, 4.5, 8.25}}, {"FNY", {0, 0.02, 0}}});
    const TableResult table = compare_tables(ours, reference, {.tolerance = 0.1});
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].difference, 0.5);
    EXPECT_EQ(table.columns[0].scale, 8);
    EXPECT_EQ(table.columns[0].scaled, 0.0625);
    EXPECT_EQ(table.columns[0].time, 1);
    EXPECT_EQ(table.columns[0].ours, 4.5);
    EXPECT_TRUE(table.columns[0].ok);
    EXPECT_EQ(table.columns[1].scale, 8e-3);
    EXPECT_FALSE(table.columns[1].ok);
    EXPECT_FALSE(table.ok());
    EXPECT_EQ(table.worst()->column, "FNY");
}

TEST(CompareTables, TheFirstDifferenceIsTheEarliestAboveTheTolerance) {
    const CsvTable reference = node_history({0, 0, 1, 1, 2, 2}, {5, 7, 5, 7, 5, 7}, {{"DX", {8, 8, 8, 8, 8, 8}}});
    const CsvTable ours = node_history({2, 2, 1, 1, 0, 0}, {7, 5, 7, 5, 7, 5}, {{"DX", {8, 16, 8.5, 8.01, 8.01, 8}}});
    const TableResult table = compare_tables(ours, reference, {.tolerance = 0.01});
    ASSERT_TRUE(table.columns[0].first);
    EXPECT_EQ(table.columns[0].first->time, 1);
    EXPECT_EQ(table.columns[0].first->object, 7);
    EXPECT_EQ(table.columns[0].first->ours, 8.5);
    EXPECT_EQ(table.columns[0].first->reference, 8);
    EXPECT_EQ(table.columns[0].time, 2);  // the largest is another
    EXPECT_FALSE(compare_tables(ours, reference, {.tolerance = 1}).columns[0].first);
}

TEST(CompareTables, TheToleranceIsTheBorder) {
    const CsvTable reference = history({0}, {{"FNX", {1}}});
    EXPECT_TRUE(compare_tables(history({0}, {{"FNX", {1.25}}}), reference, {.tolerance = 0.25}).ok());
    EXPECT_FALSE(compare_tables(history({0}, {{"FNX", {1.25}}}), reference, {.tolerance = 0.2499}).ok());
    EXPECT_TRUE(compare_tables(history({0}, {{"FNX", {1 + 9e-10}}}), reference, {}).ok());
    EXPECT_FALSE(compare_tables(history({0}, {{"FNX", {1 + 1.1e-9}}}), reference, {}).ok());
}

TEST(CompareTables, ANumberWhereTheReferenceHasNothingIsAMismatch) {
    const CsvTable zero = history({0}, {{"CE_FRIC", {0}}});
    EXPECT_TRUE(compare_tables(zero, zero, {}).ok());
    EXPECT_FALSE(compare_tables(history({0}, {{"CE_FRIC", {1e-300}}}), zero, {}).ok());
}

TEST(CompareTables, NotANumberIsNeverAgreement) {
    for (const double bad : {static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
        const CsvTable good_history = history({0, 1, 2}, {{"FNX", {1, 2, 3}}});
        const CsvTable bad_history = history({0, 1, 2}, {{"FNX", {1, bad, 3}}});
        for (const TableResult& table : {compare_tables(bad_history, good_history, {.tolerance = 1e9}),
                                         compare_tables(good_history, bad_history, {.tolerance = 1e9}),
                                         compare_tables(bad_history, bad_history, {.tolerance = 1e9})}) {
            EXPECT_FALSE(table.ok());
            EXPECT_EQ(table.columns[0].time, 1);
            EXPECT_NE(table.columns[0].remark.find("1 of 3 rows"), std::string::npos);
        }
    }
}

TEST(CompareTables, AMissingColumnIsAMismatchAndAnExtraOneIsNot) {
    const CsvTable two = history({0}, {{"FNX", {1}}, {"FNY", {1}}});
    const CsvTable one = history({0}, {{"FNX", {1}}});
    EXPECT_FALSE(compare_tables(one, two, {}).ok());
    EXPECT_EQ(compare_tables(one, two, {}).mismatches, (std::vector<std::string>{"column FNY is missing"}));
    EXPECT_TRUE(compare_tables(two, one, {}).ok());
}

TEST(CompareTables, ColumnsAndExclusionsAreObeyedAndChecked) {
    const CsvTable reference = history({0}, {{"FNX", {1}}, {"FNY", {1}}});
    const CsvTable ours = history({0}, {{"FNX", {1}}, {"FNY", {9}}});
    EXPECT_TRUE(compare_tables(ours, reference, {.columns = {"FNX"}}).ok());
    const TableResult excluded = compare_tables(ours, reference, {.exclude = {"FNY"}});
    EXPECT_TRUE(excluded.ok());
    EXPECT_EQ(excluded.notes, (std::vector<std::string>{"column FNY left out"}));
    EXPECT_FALSE(compare_tables(ours, reference, {.columns = {"FNZ"}}).ok());
    EXPECT_FALSE(compare_tables(ours, reference, {.exclude = {"FNY", "FNZ"}}).ok());
    EXPECT_FALSE(compare_tables(ours, reference, {.exclude = {"FNX", "FNY"}}).ok());
}

TEST(CompareTables, NodesCanBeChosenAndTheWorstIsNamed) {
    const CsvTable reference = node_history({0, 0}, {7, 8}, {{"DX", {1, 1}}});
    const CsvTable ours = node_history({0, 0}, {7, 8}, {{"DX", {1, 2}}});
    EXPECT_EQ(compare_tables(ours, reference, {}).columns[0].object, 8);
    EXPECT_TRUE(compare_tables(ours, reference, {.objects = {7}}).ok());
    EXPECT_FALSE(compare_tables(ours, reference, {.objects = {7, 99}}).ok());
}

TEST(CompareTables, InterpolatesLinearly) {
    const CsvTable fine = history({0, 1, 2, 3, 4}, {{"FNX", {0, 2, 4, 6, 8}}});
    const CsvTable coarse = history({0, 1.5, 3}, {{"FNX", {0, 3, 6}}});
    const TableResult table = compare_tables(fine, coarse, {});
    EXPECT_TRUE(table.ok());
    EXPECT_EQ(table.rows, 3U);
    EXPECT_TRUE(compare_tables(coarse, fine, {}).ok());
}

}  // namespace
}  // namespace type21
