/// @file A failure as a small file that reproduces it bit for bit.
///
/// The format of decide (decision_json.h) with one block, one query and its exact answer, and beside them
///   "with": the method under test, "what": the complaint, "found": {"family", "seed", "block", "query"}.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/decisions/fuzz/fuzz.h"
#include "verification/decisions/fuzz/shrink.h"

namespace type21 {

/// The failure made small, as the text of a file.
nlohmann::ordered_json failure_json(const FuzzFailure& failure, const std::string& family, const FuzzOptions& options);

/// The answers of every arithmetic to one query, one line each: plain double, double with a bound, intervals, rational
/// numbers, the reference, the optimized implementation, the second opinion; and the margin.
std::string every_answer(const DecisionTool& tool, const ContactQuery& query);

}  // namespace type21
