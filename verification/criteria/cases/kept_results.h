/// @file Results of the criteria of a run, kept for the next time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/criteria/cases/criterion_result.h"

namespace type21 {

/// The results kept for the run in `folder`. Nothing when there are none, when they belong to another key, or when the
/// files of the run have changed since.
/// @param folder  folder of the run; the kept results are beside it, in <folder>.criteria.json
/// @param key     digest of everything that the run depends on
std::optional<std::vector<CriterionResult>> kept_results(const std::filesystem::path& folder, const std::string& key);

/// Keeps the results. If one of them does not hold, or they cannot be written, the old ones are removed and nothing is
/// kept.
void keep_results(const std::filesystem::path& folder, const std::string& key,
                  const std::vector<CriterionResult>& results);

}  // namespace type21
