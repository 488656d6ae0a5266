#include <gtest/gtest.h>

#include "verification/results/compare/match_rows.h"
#include "verification/tests/results/compare/tables.h"

namespace type21 {
namespace {

using test::history;
using test::node_history;

CsvTable times(std::vector<double> time) {
    std::vector<double> values(time.size(), 1.0);
    return history(std::move(time), {{"FNX", values}});
}

TEST(MatchRows, TimesOfSinglePrecisionFindTheirPartners) {
    const std::vector<double> times{0, 1e-6, 2e-6, 2.99e-4, 3e-4};
    CsvTable ours = history(times, {{"FNX", {0, 1, 2, 299, 300}}});
    std::vector<double> stored;
    for (const double time : times)
        stored.push_back(static_cast<double>(static_cast<float>(time)));
    CsvTable reference = history(stored, {{"FNX", {0, 1, 2, 299, 300}}});
    EXPECT_TRUE(match_rows(ours, reference).interpolated);
    reference.rounding = 0x1p-24;
    EXPECT_FALSE(match_rows(ours, reference).interpolated);
    EXPECT_EQ(match_rows(ours, reference).pairs.size(), 5U);
    // Where the rounding is as large as the step, a neighbour is no partner.
    EXPECT_EQ(time_tolerance({0, 1, 2}, {0, 1, 2}, 10), 0.25);
}

TEST(MatchRows, TheThinnerFileDecidesWhicheverSideItIsOn) {
    const CsvTable full = times({0, 1, 2, 3, 4});
    const CsvTable thin = times({0, 2, 4});
    for (const RowMatch& match : {match_rows(full, thin), match_rows(thin, full)}) {
        EXPECT_EQ(match.pairs.size(), 3U);
        EXPECT_TRUE(match.mismatches.empty());
        EXPECT_FALSE(match.interpolated);
    }
    EXPECT_EQ(match_rows(full, thin).pairs[1].ours.row, 2U);
    EXPECT_EQ(match_rows(full, thin).pairs[1].reference.row, 1U);
    EXPECT_EQ(match_rows(thin, full).pairs[1].ours.row, 1U);
}

TEST(MatchRows, TimesMayDifferByAMillionthOfTheStep) {
    const RowMatch same = match_rows(times({0, 1 + 0.9e-6, 2}), times({0, 1, 2}));
    EXPECT_FALSE(same.interpolated);
    EXPECT_TRUE(same.mismatches.empty());
    EXPECT_TRUE(match_rows(times({0, 1 + 1.1e-6, 2}), times({0, 1, 2})).interpolated);
}

TEST(MatchRows, InterpolatesTheFullerFileAndSaysSo) {
    const CsvTable full = history({0, 1, 2, 3}, {{"FNX", {0, 10, 20, 30}}});
    const CsvTable thin = history({0, 1.25, 2.5}, {{"FNX", {0, 12.5, 25}}});
    const RowMatch match = match_rows(full, thin);
    ASSERT_TRUE(match.interpolated);
    ASSERT_EQ(match.pairs.size(), 3U);
    EXPECT_EQ(match.pairs[1].ours.row, 1U);
    EXPECT_EQ(match.pairs[1].ours.next, 2U);
    EXPECT_NEAR(match.pairs[1].ours.weight, 0.25, 1e-15);
    ASSERT_EQ(match.notes.size(), 1U);
    EXPECT_NE(match.notes[0].find("interpolated"), std::string::npos);
}

TEST(MatchRows, ARunThatStopsEarlyIsAMismatch) {
    const RowMatch match = match_rows(times({0, 1, 2}), times({0, 1, 2, 3}));
    ASSERT_EQ(match.mismatches.size(), 1U);
    EXPECT_NE(match.mismatches[0].find("t = 3"), std::string::npos);
}

TEST(MatchRows, ARunThatGoesOnIsAMismatch) {
    EXPECT_EQ(match_rows(times({0, 1, 2, 3, 4}), times({0, 1, 2})).mismatches.size(), 1U);
    EXPECT_TRUE(match_rows(times({0, 1, 2, 3, 4}), times({0, 1, 2}), {0, 2}).mismatches.empty());
}

TEST(MatchRows, InterpolatedEndsMayBeOffByAStepAndNoMore) {
    EXPECT_TRUE(match_rows(times({0, 0.9, 1.8, 2.7, 3.6}), times({0, 2, 4})).mismatches.empty());
    EXPECT_FALSE(match_rows(times({0, 0.9, 1.8, 2.7, 3.6}), times({0, 2, 4, 6})).mismatches.empty());
}

TEST(MatchRows, TheWindowLeavesRowsOut) {
    const RowMatch match = match_rows(times({0, 1, 2, 3}), times({0, 1, 2, 3}), {1, 2});
    EXPECT_EQ(match.pairs.size(), 2U);
    EXPECT_TRUE(match.mismatches.empty());
    EXPECT_FALSE(match_rows(times({0, 1}), times({0, 1}), {5, 6}).mismatches.empty());
}

TEST(MatchRows, TheNodesOfTheReferenceMustBeThere) {
    const CsvTable ours = node_history({0, 0, 1, 1}, {7, 8, 7, 8}, {{"DX", {1, 2, 3, 4}}});
    const CsvTable reference = node_history({0, 0, 1, 1}, {8, 9, 8, 9}, {{"DX", {2, 0, 4, 0}}});
    const RowMatch match = match_rows(ours, reference);
    EXPECT_EQ(match.pairs.size(), 2U);  // 8 twice; our 7 is nobody's business
    ASSERT_EQ(match.mismatches.size(), 1U);
    EXPECT_NE(match.mismatches[0].find("object 9 has no partner at 2 of 2 times"), std::string::npos);
}

TEST(MatchRows, ARowTwiceIsAMismatch) {
    const CsvTable twice = node_history({0, 0}, {7, 7}, {{"DX", {1, 2}}});
    const CsvTable once = node_history({0}, {7}, {{"DX", {1}}});
    EXPECT_FALSE(match_rows(twice, once).mismatches.empty());
}

TEST(MatchRows, NoRowsAndOtherKindsAreMismatches) {
    EXPECT_FALSE(match_rows(times({}), times({0})).mismatches.empty());
    EXPECT_FALSE(match_rows(times({0}), times({})).mismatches.empty());
    EXPECT_FALSE(match_rows(times({0}), node_history({0}, {7}, {{"FNX", {1}}})).mismatches.empty());
    EXPECT_FALSE(match_rows(times({0}), times({1})).mismatches.empty());
}

}  // namespace
}  // namespace type21
