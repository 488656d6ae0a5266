/// @file Check results for people (a table), for programs (JSON) and for CI (JUnit XML).
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/criteria/cases/check_result.h"

namespace type21 {

/// One line a check, a second one where something failed, and a summary.
std::string check_table(const std::vector<CheckResult>& results);

/// An array, one record a check.
nlohmann::ordered_json check_json(const std::vector<CheckResult>& results);

std::string check_junit(const std::vector<CheckResult>& results);

}  // namespace type21
