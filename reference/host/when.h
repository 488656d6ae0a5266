/// @file Cycle and time in the words of a message.
#pragma once

#include <string>

#include <fmt/format.h>

#include "reference/host/state.h"
#include "reference/model/units.h"

namespace type21 {

/// "in cycle 12 at t = 1.2e-05 s".
inline std::string when(const HostState& state, const UnitSystem& units) {
    return fmt::format("in cycle {} at t = {:.9g} {}", state.cycle, state.time, units.name(dim::time));
}

}  // namespace type21
