/// @file A comparison as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "verification/results/compare/compare_folders.h"

namespace type21 {

/// One block for each file, one line for each column, and a last line with the verdict.
std::string to_text(const FolderComparison& comparison);

/// Infinite differences (NaN in a history) are written as the string "inf", since JSON has no such number.
nlohmann::ordered_json to_json(const FolderComparison& comparison);

}  // namespace type21
