/// @file What the coefficients of a friction law and the constant of a filter must fulfil, on the card and in
/// /FRICTION.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reference/contract/departures.h"
#include "reference/model/units.h"

namespace type21 {

/// A condition that a value breaks.
struct ConditionFault {
    size_t rank = 0;  ///< of C1..C6, from 0
    std::string rule;
    std::string remedy;
};

/// The conditions of the Renard law, one fault for each that is broken:
///   0 < C5 < C6,  C1 < C3,  C2 < C3,  C4 < C1,  C4 < C2
/// @param c      C1..C6: static, dynamic, largest, smallest coefficient [-], first and second critical speed [velocity]
/// @param units  those of c.  Source: page, comment 13; formulation 8
std::vector<ConditionFault> renard_faults(const std::array<double, 6>& c, const UnitSystem& units);

/// Xfreq is not negative; with Ifiltr 1 and 2 it is between 0 and 1 (D07: with Ifiltr 2 at least 2 pi). 0 means no
/// filter. Source: page, comment 15; formulation 8, 12 (D07)
std::optional<ConditionFault> filter_fault(int ifiltr, double xfreq, const AsBuilt& as_built);

}  // namespace type21
