#include <limits>
#include <mutex>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reference/host/prepare_deck.h"
#include "verification/criteria/cases/verify_cases.h"
#include "verification/results/record/run_deck.h"
#include "verification/support/in_parallel.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::TempFolder;
using test::without_mark;
namespace fs = std::filesystem;
using Json = nlohmann::json;

/// run.json without what differs from run to run: ids, wall time, time spent in decisions.
Json lasting(const fs::path& path) {
    Json json = Json::parse(test::read_text(path));
    for (const char* key : {"run_id", "restarted_from", "wall_seconds"})
        json.erase(key);
    for (Json& result : json["results"])
        result["decisions"].erase("seconds");
    return json;
}

std::set<fs::path> files_in(const fs::path& folder) {
    std::set<fs::path> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() != ".t21")
            names.insert(entry.path().lexically_relative(folder));
    return names;
}

/// "" or the first file that differs.
std::string difference(const fs::path& one, const fs::path& other) {
    if (files_in(one) != files_in(other)) return "other files";
    for (const fs::path& name : files_in(one)) {
        const bool same = name == "run.json" ? lasting(one / name) == lasting(other / name)
                                             : without_mark(one / name) == without_mark(other / name);
        if (!same) return name.string();
    }
    return "";
}

/// Runs a deck as a whole, and in pieces: interrupted ten times, each time gone on with from the checkpoint.
/// @return "" or what differs
std::string compare_with_pieces(const CaseRun& run, const std::string& with, bool paraview, long& restarts) {
    const PreparedDeck deck = prepare_deck(run.deck.string(), run.as_built, true, run.thickness.string());
    if (!deck.scene) return "";  // the case is that the deck is refused
    const TempFolder folder;
    RunFiles files;
    files.paraview = paraview;
    const RunSummary whole = run_scene(*deck.scene, deck.problems, folder / "whole", {}, deck.options(), with, files);
    files.inputs = deck.files;
    files.checkpoint_every = 1L << 40;  // at the interruptions only
    constexpr int pieces = 11;
    for (int piece = 1; piece <= pieces; ++piece) {
        long cycle = 0;
        // The last piece is let go to its end.
        const long end = piece == pieces ? std::numeric_limits<long>::max() : piece * whole.cycles / pieces;
        files.interrupted = [&] { return cycle >= end; };
        const RunSummary summary = run_scene(
            *deck.scene, deck.problems, folder / "pieces", [&](const RunProgress& p) { cycle = p.cycle + 1; },
            deck.options(), with, files);
        if (summary.state != RunSummary::State::interrupted) break;
        files.restart = folder / "pieces/checkpoint.t21";
        ++restarts;
    }
    return difference(folder / "whole", folder / "pieces");
}

class Restart : public testing::TestWithParam<const char*> {};

TEST_P(Restart, AtAnyOfTenCyclesOfEveryCaseGivesTheSameBits) {
    std::vector<std::string> problems;
    const std::vector<Case> cases = read_cases(fs::path(TYPE21_SOURCE_DIR) / "cases", {}, problems);
    ASSERT_TRUE(problems.empty()) << problems.front();
    std::vector<std::pair<std::string, CaseRun>> runs;
    for (const Case& a_case : cases)
        for (const CaseRun& run : a_case.runs)
            runs.emplace_back(a_case.name + "/" + run.name, run);
    ASSERT_GT(runs.size(), 100U);
    std::mutex reporting;
    long all_restarts = 0;
    in_parallel(runs.size(), 2, [&](size_t i) {
        long restarts = 0;
        // Files for ParaView are slow to write: those of some runs stand for all.
        const std::string different = compare_with_pieces(runs[i].second, GetParam(), i % 25 == 0, restarts);
        const std::lock_guard<std::mutex> lock(reporting);
        all_restarts += restarts;
        EXPECT_EQ(different, "") << runs[i].first;
    });
    // Some decks are refused, some runs are shorter.
    EXPECT_GT(all_restarts, 6 * static_cast<long>(runs.size()));
}

INSTANTIATE_TEST_SUITE_P(Restart, Restart, testing::Values("reference", "optimized"),
                         [](const auto& p) { return std::string(p.param); });

}  // namespace
}  // namespace type21
