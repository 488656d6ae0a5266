/// @file Long runs and sliding continuity as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/stability/finding.h"
#include "verification/stability/sliding.h"

namespace type21::stability {

std::string to_text(const LongRun& run);
/// A table of the residual jumps, and in words where the method itself jumps.
std::string to_text(const std::vector<SlidingRow>& rows);

nlohmann::ordered_json to_json(const LongRun& run);
nlohmann::ordered_json to_json(const std::vector<SlidingRow>& rows);

/// True when no cycle is out of contact and no residual is above its bound.
bool holds(const SlidingRow& row);
/// The largest residual that holds, given the jumps of the facets [N].
double residual_bound(const SlidingRow& row, const Jumps& facets);

}  // namespace type21::stability
