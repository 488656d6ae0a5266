/// @file The points of the laws as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "reference/model/model.h"
#include "verification/explain/law_points.h"

namespace type21 {

/// One line an interface.
std::string to_text(const std::vector<InterfaceLaws>& all, const UnitSystem& units);
/// {"units": {...}, "interfaces": [{"id", "title", "ifric", "pmax", "several_mu", "difference", "pressures",
///   "curves": [{"speed", "mu", "mu_optimized"}], "friction": [[pressure, speed, mu]],
///   "normal": [[penetration, pressure]], "heat": [[distance, conductance]]}]}
nlohmann::ordered_json to_json(const std::vector<InterfaceLaws>& all, const UnitSystem& units);

}  // namespace type21
