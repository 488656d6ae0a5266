/// @file Lockstep results for people and for programs.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/criteria/cases/criterion_result.h"
#include "verification/criteria/lockstep/lockstep_decks.h"

namespace type21 {

/// The differences, each refused deck, and the sums over all runs.
std::string to_text(const std::vector<LockstepRecord>& records);

/// {"ulps_allowed", "ok", "all": {...}, "runs": [{...}]}; infinite differences are the string "inf".
nlohmann::ordered_json to_json(const std::vector<LockstepRecord>& records);

/// The comparison as a criterion of a run: the largest difference of a force, a heat, a stiffness or a sum in ulps.
CriterionResult lockstep_criterion(const LockstepRecord& record, const std::string& case_name, const std::string& run);

}  // namespace type21
