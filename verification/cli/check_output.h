/// @file The output of `type21 check` for a deck without errors.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "reference/model/host_scene.h"
#include "verification/results/balance/time_zero.h"

namespace type21::cli {

/// Units, sizes, tools, and for each interface its fields, effects, time-0 quantities and initial penetrations (the
/// first 20).
std::string check_text(const HostScene& scene, const std::vector<TimeZero>& zero);

/// The same, with every initial penetration.
nlohmann::ordered_json check_json(const HostScene& scene, const std::vector<TimeZero>& zero, const Problems& problems);

/// The geometry at time 0, for drawings: `nodes` as [id, x, y, z] [length], and for each interface its `secondary`
/// and `main` segments as lists of 3 or 4 node ids.
nlohmann::ordered_json geometry_json(const HostScene& scene);

/// `{"valid": false, "problems": [...]}` of a deck that is refused.
nlohmann::ordered_json refused_json(const std::string& deck, const Problems& problems);

}  // namespace type21::cli
