/// @file Results of the criteria for people (a table), for programs (JSON) and for CI (JUnit XML).
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/criteria/cases/criterion_result.h"

namespace type21 {

/// One line for each criterion, a second one where it failed, and a summary.
std::string criteria_table(const std::vector<CriterionResult>& results);

/// An array with one record for each criterion.
nlohmann::ordered_json criteria_json(const std::vector<CriterionResult>& results);

std::string criteria_junit(const std::vector<CriterionResult>& results);

}  // namespace type21
