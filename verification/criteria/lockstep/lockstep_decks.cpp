#include "verification/criteria/lockstep/lockstep_decks.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <set>

#include <fmt/format.h>

#include "reference/host/prepare_deck.h"
#include "verification/results/record/run_deck.h"
#include "verification/support/contact_choice.h"
#include "verification/support/in_parallel.h"

namespace type21 {

namespace fs = std::filesystem;

namespace {

std::string replaced(std::string text, char from, char to) {
    std::replace(text.begin(), text.end(), from, to);
    return text;
}

/// Each contact runs by itself; what comes apart is measured at the end.
void run_apart(const PreparedDeck& deck, const fs::path& folder, const std::string& search, LockstepRecord& record) {
    run_scene(*deck.scene, deck.problems, folder / "reference", {}, deck.options(), "reference");
    run_scene(*deck.scene, deck.problems, folder / "optimized", {}, deck.options(), contact_maker("optimized", search));
    const FolderComparison both = compare_folders(folder / "optimized", folder / "reference", {});
    record.apart = 0;
    for (const FileComparison& file : both.files) {
        const ColumnResult* worst = file.table.worst();
        if (worst == nullptr || !(worst->scaled > *record.apart)) continue;
        record.apart = worst->scaled;
        record.apart_where = fmt::format("{} {}", file.name, worst->column);
    }
}

LockstepRecord step_one(const LockstepTarget& target, const LockstepOptions& options) {
    LockstepRecord record;
    record.target = target;
    const auto start = std::chrono::steady_clock::now();
    try {
        const CaseRun& run = target.run;
        const PreparedDeck deck = prepare_deck(run.deck.string(), run.as_built, true, run.thickness.string());
        record.refused = !deck.scene;
        for (const Problem& problem : deck.problems.list())
            if (record.refused && record.error.empty() && problem.severity == Severity::error)
                record.error = to_text(problem);
        if (deck.scene) {
            record.result = lockstep(*deck.scene, deck.options(), contact_maker("reference"),
                                     contact_maker("optimized", options.search));
            if (!options.free_runs.empty())
                run_apart(deck, options.free_runs / replaced(target.name, '/', '_'), options.search, record);
        }
    } catch (const std::exception& error) {
        record.error = error.what();
    }
    record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return record;
}

}  // namespace

bool LockstepRecord::ok() const {
    if (refused) return true;
    if (!error.empty()) return false;
    return result.ok();
}

std::vector<LockstepTarget> lockstep_targets(const std::vector<Case>& cases,
                                             const std::optional<std::string>& as_built) {
    std::vector<LockstepTarget> targets;
    for (const Case& a_case : cases) {
        std::set<std::pair<fs::path, fs::path>> seen;
        for (CaseRun run : a_case.runs) {
            if (as_built && !seen.emplace(run.deck, run.thickness).second) continue;
            const std::string name = fmt::format("{}/{}", a_case.name, run.name);
            if (as_built) run.as_built = *as_built;
            targets.push_back({name, run});
        }
    }
    return targets;
}

std::vector<LockstepRecord> lockstep_decks(const std::vector<LockstepTarget>& targets, const LockstepOptions& options) {
    std::vector<LockstepRecord> records(targets.size());
    std::mutex reporting;
    in_parallel(targets.size(), options.jobs, [&](size_t t) {
        records[t] = step_one(targets[t], options);
        const std::lock_guard<std::mutex> lock(reporting);
        if (options.progress) options.progress(records[t]);
    });
    return records;
}

}  // namespace type21
