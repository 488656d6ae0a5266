#include <cmath>

#include <gtest/gtest.h>

#include "verification/criteria/cases/value_at.h"
#include "verification/tests/results/compare/tables.h"

namespace type21 {
namespace {

const CsvTable table = test::history({0, 1, 2, 4}, {{"FNX", {0, -5, 3, 1}}, {"BAD", {0, NAN, 0, 0}}});
const CsvTable nodes = test::node_history({0, 0, 1, 1}, {7, 8, 7, 8}, {{"DX", {1, 2, 3, 4}}});

TEST(ValueAt, EndLargestSmallestAndTimes) {
    EXPECT_EQ(value_at(table, "FNX", {At::Kind::end, 0}, {}), 1);
    EXPECT_EQ(value_at(table, "FNX", {At::Kind::largest, 0}, {}), 3);
    EXPECT_EQ(value_at(table, "FNX", {At::Kind::smallest, 0}, {}), -5);
    EXPECT_EQ(value_at(table, "FNX", {At::Kind::time, 1}, {}), -5);
    EXPECT_EQ(value_at(table, "FNX", {At::Kind::time, 1 + 1e-7}, {}), -5);
    EXPECT_EQ(value_at(table, "FNX", {At::Kind::time, 3.5}, {}), 1.5);
    EXPECT_EQ(value_at(nodes, "DX", {At::Kind::end, 0}, 7), 3);
    EXPECT_EQ(value_at(nodes, "DX", {At::Kind::smallest, 0}, 8), 2);
}

TEST(ValueAt, SaysWhatIsNotThere) {
    EXPECT_THROW(value_at(table, "FNY", {}, {}), NoValue);
    EXPECT_THROW(value_at(table, "BAD", {}, {}), NoValue);
    EXPECT_THROW(value_at(table, "FNX", {}, 7), NoValue);
    EXPECT_THROW(value_at(table, "FNX", {At::Kind::time, 4.1}, {}), NoValue);
    EXPECT_THROW(value_at(nodes, "DX", {}, {}), NoValue);
    EXPECT_THROW(value_at(nodes, "DX", {}, 9), NoValue);
}

}  // namespace
}  // namespace type21
