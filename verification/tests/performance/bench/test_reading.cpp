#include <gtest/gtest.h>

#include "reference/host/prepare_deck.h"
#include "verification/performance/bench/reading.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

TEST(BenchReading, TheDeckIsOneThatRuns) {
    const test::TempFolder folder;
    const PreparedDeck deck = prepare_deck(bench::write_large_deck(folder.path().string(), 900), "", true);
    ASSERT_TRUE(deck.scene) << to_text(deck.problems.list().front());
    EXPECT_TRUE(deck.problems.list().empty()) << to_text(deck.problems.list().front());
    EXPECT_EQ(deck.scene->model->shells.size(), 2U * 29 * 29)
        << "blank and tool, all of it in contact when it is small";
}

TEST(BenchReading, IsMeasuredInAProcessOfItsOwn) {
    const bench::ReadingRow row = bench::measure_reading(10000);
    EXPECT_EQ(row.nodes, 100U * 100 + 51 * 51 + 1);
    EXPECT_EQ(row.shells, 99U * 99 + 50 * 50);
    EXPECT_GT(row.bytes, 70U * row.nodes);
    EXPECT_GT(row.peak_bytes_per_node, 100);
    EXPECT_TRUE(bench::reading_targets(row).empty()) << "a small deck says nothing of a large one";
    EXPECT_EQ(bench::to_json({row}).at(0).at("nodes"), row.nodes);
    EXPECT_NE(bench::to_text(std::vector<bench::ReadingRow>{row}).find("B per node"), std::string::npos);
}

}  // namespace
}  // namespace type21
