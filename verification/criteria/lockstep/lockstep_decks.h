/// @file Lockstep over many decks.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verification/criteria/cases/case_file.h"
#include "verification/criteria/lockstep/lockstep.h"

namespace type21 {

/// A run to step.
struct LockstepTarget {
    std::string name;  ///< "incline/documented", or the path of a deck
    CaseRun run;
};

struct LockstepRecord {
    LockstepTarget target;
    LockstepResult result;
    bool refused = false;         ///< the deck has errors: nothing was run
    std::string error;            ///< the first of them, or an internal error
    std::optional<double> apart;  ///< separate runs: largest difference of a history relative to its scale [-]
    std::string apart_where;      ///< file and column of it
    double seconds = 0;           ///< of wall time

    /// The decisions are the same, and the numbers within lockstep_ulps. A refused deck counts as ok.
    bool ok() const;
};

struct LockstepOptions {
    int jobs = 1;
    /// Folder for separate runs of both, each with its own contact; empty: none.
    std::filesystem::path free_runs;
    std::function<void(const LockstepRecord&)> progress;  ///< after each, never twice at the same time
    std::string search{};                                 ///< of the optimized contact; empty: its default
};

/// The runs of the cases, with the departures of their case.toml; with `as_built` each deck once, with these
/// departures.
std::vector<LockstepTarget> lockstep_targets(const std::vector<Case>& cases,
                                             const std::optional<std::string>& as_built);

/// In the order of the targets, whatever the number of jobs.
std::vector<LockstepRecord> lockstep_decks(const std::vector<LockstepTarget>& targets, const LockstepOptions& options);

}  // namespace type21
