/// @file Accuracy against time as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "verification/performance/accuracy/measure.h"

namespace type21::accuracy {

std::string to_text(const Result& result);
/// What scripts/report reads: verification/performance/accuracy/README.md says what is in it.
nlohmann::ordered_json to_json(const Result& result);

}  // namespace type21::accuracy
