/// @file Which mutations make a criterion fail.
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
    bool red = false;            ///< a criterion that holds without the mutation fails with it
    std::string case_name, run;  ///< of that criterion; a file of decisions has no run
    std::string criterion;       ///< its id
    double difference = 0;       ///< in the measure of the tolerance; of decisions: how many had been compared
    double tolerance = 0;
    std::string detail;  ///< where, or what went wrong with the mutation itself
    int tried = 0;       ///< runs or files
    double seconds = 0;  ///< of wall time
};

struct ScoreOptions {
    std::filesystem::path decisions;  ///< folder of the exact answers
    std::filesystem::path scratch;    ///< folder for the runs
    std::string with = "reference";   ///< implementation that is broken
    int jobs = 1;
    std::function<void(const MutationVerdict&)> progress;  ///< after each, never twice at the same time
};

/// Runs the cases once unchanged. Then, for each mutation, runs those that have the broken effect, the fastest first,
/// until a criterion fails. Only criteria that hold without the mutation count.
/// @return one verdict for each mutation, in their order
std::vector<MutationVerdict> score(const std::vector<Mutation>& mutations, const std::vector<Case>& cases,
                                   const ScoreOptions& options);

/// One line a mutation, then the score and the survivors.
std::string to_text(const std::vector<MutationVerdict>& verdicts);
/// {"mutations": [{"name", "effect", "broken", "case", "criterion", "red", "difference", ...}], "killed", "all"}
nlohmann::ordered_json to_json(const std::vector<MutationVerdict>& verdicts);

}  // namespace type21
