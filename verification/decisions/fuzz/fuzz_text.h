/// @file The result of a fuzzing run: base rates beside the failures.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/decisions/fuzz/fuzz.h"

namespace type21 {

/// One line for each question family with its base rates, and the first failures below.
std::string to_text(const std::vector<FuzzTally>& tallies, const FuzzOptions& options);
nlohmann::ordered_json to_json(const std::vector<FuzzTally>& tallies, const FuzzOptions& options);

}  // namespace type21
