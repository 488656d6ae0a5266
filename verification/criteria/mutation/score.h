/// @file Which mutations the checks see.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/criteria/cases/case_file.h"
#include "verification/criteria/mutation/mutation.h"

namespace type21 {

struct MutationVerdict {
    Mutation mutation;
    bool red = false;            ///< a check fails with the mutation that holds without
    std::string case_name, run;  ///< of that check; a file of decisions has no run
    std::string check;           ///< its id
    double difference = 0;       ///< in the measure of the tolerance; of decisions: how many had been compared
    double tolerance = 0;
    std::string detail;  ///< where, or what went wrong with the mutation itself
    int tried = 0;       ///< runs or files
    double seconds = 0;  ///< of wall time
};

struct ScoreOptions {
    std::filesystem::path decisions;  ///< folder of truth files
    std::filesystem::path scratch;    ///< folder for the runs
    std::string with = "reference";   ///< who computes the contact that is broken
    int jobs = 1;
    std::function<void(const MutationVerdict&)> progress;  ///< after each, never twice at the same time
};

/// Runs the cases once as they are; then, for each mutation, those that have what it breaks, the fastest first, until a
/// check turns red. Only checks that hold without the mutation count.
/// @return one for each mutation, in their order
std::vector<MutationVerdict> score(const std::vector<Mutation>& mutations, const std::vector<Case>& cases,
                                   const ScoreOptions& options);

/// One line a mutation, then the score and the survivors.
std::string to_text(const std::vector<MutationVerdict>& verdicts);
/// {"mutations": [{"name", "effect", "broken", "case", "check", "red", "difference", ...}], "killed", "all"}
nlohmann::ordered_json to_json(const std::vector<MutationVerdict>& verdicts);

}  // namespace type21
