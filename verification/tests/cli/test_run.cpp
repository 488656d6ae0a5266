#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/results/tables/csv_table.h"
#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::DeckCopy;
using test::Outcome;
using test::TempFolder;
namespace fs = std::filesystem;

std::string run_line(const DeckCopy& deck, const std::string& more = "") {
    return "run " + test::in_quotes(deck.starter) + " --out " + test::in_quotes(deck.out()) + " " + more;
}

nlohmann::json run_json(const DeckCopy& deck) {
    return nlohmann::json::parse(test::read_text(fs::path(deck.out()) / "run.json"));
}

size_t count_of(const std::string& text, const std::string& words) {
    size_t count = 0;
    for (size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
        ++count;
    return count;
}

TEST(Run, ParaviewHasEveryTimeOfTheHistoriesAlsoWhenTheRunStops) {
    const DeckCopy deck("invn1_inverted");
    EXPECT_EQ(test::type21(run_line(deck, "--quiet --paraview")).code, 4);
    const fs::path out = deck.out();
    const size_t times = read_csv(out / "interface_1.csv").rows();
    EXPECT_GT(times, 10U);
    for (const char* name : {"blank_1", "tool_1"}) {
        const std::string list = test::read_text(out / ("paraview/" + std::string(name) + ".pvd"));
        EXPECT_EQ(count_of(list, "<DataSet "), times);
        EXPECT_NE(list.find("</VTKFile>"), std::string::npos);
    }
    // A list and a file a time for blank and tool, and nothing half-written.
    EXPECT_EQ(static_cast<size_t>(std::distance(fs::directory_iterator(out / "paraview"), {})), 2 * (times + 1));
}

TEST(Run, WritesHistoriesAndRunJson) {
    const DeckCopy deck("flat_press");
    const Outcome outcome = test::type21(run_line(deck, "--as-built all"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const fs::path out = deck.out();
    EXPECT_EQ(read_csv(out / "interface_1.csv").rows(), 300U);
    EXPECT_EQ(read_csv(out / "nodes.csv").rows(), 15U * 300U);
    EXPECT_EQ(read_csv(out / "rbody.csv").rows(), 300U);
    const auto json = run_json(deck);
    EXPECT_EQ(json["status"], "completed");
    EXPECT_EQ(json["cycles"], 300);
    EXPECT_NE(json["as_built"].get<std::string>().find("D25"), std::string::npos);
    EXPECT_EQ(json["interfaces"][0]["parameters"].size(), 55U);
    EXPECT_LT(json["results"][0]["balance"]["power"]["relative_residual"].get<double>(), 1e-12);
    EXPECT_GT(json["results"][0]["final"]["FNZ"].get<double>(), 0.0);
    for (const char* key :
         {"version", "commit", "compiler", "flags", "build_type", "cpu", "wall_seconds", "deck", "units"})
        EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_NE(outcome.out.find("300 cycles"), std::string::npos);
    EXPECT_LE(test::count_lines(outcome.err), 10U + 3U)
        << outcome.err;  // ten of progress, and what the reader warns about
}

/// A CSV without its last line, which names the run.
std::string rows_of(const fs::path& path) {
    const std::string text = test::read_text(path);
    return text.substr(0, text.rfind("# type21 "));
}

// @manual field Bumult
TEST(Run, TheSortedSearchGivesTheHistoriesOfTheTreeAndSaysWhatItDid) {
    const DeckCopy tree("cylinder_slide"), sorted("cylinder_slide");
    ASSERT_EQ(test::type21(run_line(tree, "--quiet --with optimized --search tree")).code, 0);
    const Outcome outcome = test::type21(run_line(sorted, "--with optimized --search sorted"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* file : {"interface_1.csv", "nodes.csv", "rbody.csv"})
        EXPECT_EQ(rows_of(fs::path(tree.out()) / file), rows_of(fs::path(sorted.out()) / file)) << file;
    EXPECT_NE(outcome.out.find("margin 0.6256 mm (Bumult 0.2), sorted in 6 of 400 cycles"), std::string::npos);
    const auto search = run_json(sorted)["results"][0]["sorted_search"];
    EXPECT_EQ(search["bumult"], 0.2);
    EXPECT_EQ(search["cycles"], 400);
    EXPECT_EQ(search["sorts"], 6);
    EXPECT_GT(search["bytes"], 0);
    EXPECT_GT(search["candidates_per_node"], search["boxes_per_node"]);
    EXPECT_FALSE(run_json(tree)["results"][0].contains("sorted_search"));
}

TEST(Run, TheReferenceHasNoChoiceOfSearch) {
    const DeckCopy deck("flat_press");
    for (const char* with : {"", "--with reference "}) {
        const Outcome outcome = test::type21(run_line(deck, std::string(with) + "--search sorted"));
        EXPECT_EQ(outcome.code, 1);
        EXPECT_NE(outcome.err.find("--search sorted: the reference has one search only"), std::string::npos)
            << outcome.err;
        EXPECT_FALSE(fs::exists(deck.out()));
    }
}

TEST(Run, QuietIsQuiet) {
    const DeckCopy deck("flat_press");
    const Outcome outcome = test::type21(run_line(deck, "--quiet"));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.find("%"), std::string::npos);
}

TEST(Run, ObeysTheHistoryInterval) {
    const DeckCopy deck("flat_press");
    deck.replace(deck.engine, "               5e-07", "               1e-05");
    ASSERT_EQ(test::type21(run_line(deck)).code, 0);
    const CsvTable table = read_csv(fs::path(deck.out()) / "interface_1.csv");
    // Cycle 0, every tenth or, where the accumulated time falls short of the output time by a rounding, the next, and
    // cycle 299.
    EXPECT_EQ(table.rows(), 31U);
    EXPECT_EQ(table.time.front(), 0);
    EXPECT_NEAR(table.time.back(), 2.99e-4, 1e-12);
}

TEST(Run, ReplacesAnEarlierResultAndNoOther) {
    const DeckCopy deck("flat_press");
    ASSERT_EQ(test::type21(run_line(deck, "--quiet")).code, 0);
    fs::copy_file(fs::path(deck.out()) / "interface_1.csv", fs::path(deck.out()) / "interface_99.csv");
    ASSERT_EQ(test::type21(run_line(deck, "--quiet")).code, 0);
    EXPECT_FALSE(fs::exists(fs::path(deck.out()) / "interface_99.csv"));
    // A case's measured histories are not ours to replace.
    fs::remove(fs::path(deck.out()) / "run.json");
    EXPECT_EQ(test::type21(run_line(deck, "--quiet")).code, 1);
    EXPECT_TRUE(fs::exists(fs::path(deck.out()) / "interface_1.csv"));
}

TEST(Run, AFaultyDeckWritesNothing) {
    const DeckCopy deck("flat_press");
    deck.replace(deck.starter, "/SURF/PART/1\n", "/SURF/PART/17\n");
    const Outcome outcome = test::type21(run_line(deck));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_FALSE(fs::exists(deck.out()));
}

TEST(Run, NeedsAnEngineDeck) {
    const DeckCopy deck("flat_press");
    fs::remove(deck.engine);
    const Outcome outcome = test::type21(run_line(deck));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("flat_press_0001.rad"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(deck.out()));
}

TEST(Run, AFolderThatCannotBeUsedIsAUsageError) {
    const DeckCopy deck("flat_press");
    test::write_text(deck.out(), "a file");
    const Outcome outcome = test::type21(run_line(deck));
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("is a file"), std::string::npos) << outcome.err;
    EXPECT_EQ(test::type21("run " + test::in_quotes(deck.starter) + " --out /proc/type21").code, 1);
}

TEST(Run, AStopKeepsWhatWasWrittenAndExitsFour) {
    const DeckCopy deck("invn1_inverted");
    const Outcome outcome = test::type21(run_line(deck, "--as-built all"));
    EXPECT_EQ(outcome.code, 4);
    EXPECT_NE(outcome.err.find("node"), std::string::npos);
    EXPECT_EQ(run_json(deck)["status"], "stopped");
    EXPECT_GT(read_csv(fs::path(deck.out()) / "interface_1.csv").rows(), 50U);
}

TEST(Run, TwoRunsWriteTheSameBytes) {
    const DeckCopy first("cylinder_slide"), second("cylinder_slide");
    ASSERT_EQ(test::type21(run_line(first, "--quiet")).code, 0);
    ASSERT_EQ(test::type21(run_line(second, "--quiet")).code, 0);
    for (const char* name : {"interface_1.csv", "nodes.csv", "rbody.csv"})
        EXPECT_EQ(test::without_mark(fs::path(first.out()) / name), test::without_mark(fs::path(second.out()) / name))
            << name;
}

}  // namespace
}  // namespace type21
