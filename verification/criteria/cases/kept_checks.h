/// @file What the checks of a run gave, kept beside its results for the next time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/criteria/cases/check_result.h"

namespace type21 {

/// The checks kept for the results in `folder`. Nothing when there are none, when they belong to another key, or when
/// the results are not as they were left.
/// @param folder  of the results of a run; what is kept stands beside it in <folder>.checks.json
/// @param key     digest of all that the run depends on
std::optional<std::vector<CheckResult>> kept_checks(const std::filesystem::path& folder, const std::string& key);

/// Keeps the checks; the old ones go where one of these does not hold or cannot be kept.
void keep_checks(const std::filesystem::path& folder, const std::string& key, const std::vector<CheckResult>& checks);

}  // namespace type21
