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

/// Runs a deck as a whole, and in pieces: interrupted, and each time gone on with from the checkpoint.
/// @param tenths  where the interruptions are, ascending
/// @return "" or what differs
std::string compare_with_pieces(const CaseRun& run, const std::string& with, bool paraview,
                                const std::set<long>& tenths, long& restarts) {
    const PreparedDeck deck = prepare_deck(run.deck.string(), run.as_built, true, run.thickness.string());
    if (!deck.scene) return "";  // the case is that the deck is refused
    const TempFolder folder;
    RunFiles files;
    files.paraview = paraview;
    const RunSummary whole = run_scene(*deck.scene, deck.problems, folder / "whole", {}, deck.options(), with, files);
    files.inputs = deck.files;
    files.checkpoint_every = 1L << 40;  // at the interruptions only
    std::vector<long> ends;
    for (const long tenth : tenths)
        ends.push_back(tenth * whole.cycles / 11);
    ends.push_back(whole.cycles);                      // before the cycle in which a run stops by itself
    ends.push_back(std::numeric_limits<long>::max());  // the last piece is let go to its end
    for (const long end : ends) {
        long cycle = 0;
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
    // The first run of each case with the reference, the last one with the other: as documented, and with departures.
    const bool first = std::string(GetParam()) == "reference";
    for (const Case& a_case : cases) {
        const CaseRun& run = first ? a_case.runs.front() : a_case.runs.back();
        runs.emplace_back(a_case.name + "/" + run.name, run);
    }
    ASSERT_GT(runs.size(), 100U);
    std::mutex reporting;
    long all_restarts = 0;
    in_parallel(runs.size(), 2, [&](size_t i) {
        long restarts = 0;
        std::string different;
        try {
            // Two of ten cycles for each run, others for the next; files for ParaView, which are slow, for some.
            const auto n = static_cast<long>(i);
            different =
                compare_with_pieces(runs[i].second, GetParam(), i % 25 == 0, {1 + n % 10, 1 + (n + 5) % 10}, restarts);
        } catch (const std::exception& error) {
            different = error.what();
        }
        const std::lock_guard<std::mutex> lock(reporting);
        all_restarts += restarts;
        EXPECT_EQ(different, "") << runs[i].first;
    });
    // Some decks are refused, some runs are short.
    EXPECT_GT(all_restarts, static_cast<long>(runs.size()));
}

INSTANTIATE_TEST_SUITE_P(Restart, Restart, testing::Values("reference", "optimized"),
                         [](const auto& p) { return std::string(p.param); });

}  // namespace
}  // namespace type21
