/// @file What the coefficients of a friction law and the constant of a filter must fulfil, on the card and in
/// /FRICTION.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

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
/// @param units  those of c, for the messages.  Formulation 8, step 6; manual page, comment 13; as built: D17.
std::vector<ConditionFault> renard_faults(const std::array<double, 6>& c, const UnitSystem& units);

/// Xfreq is not negative; with Ifiltr 1 and 2 it is between 0 and 1. 0 means no filter.
/// @param xfreq  [-], or [1/time] with Ifiltr 3
/// @return the fault, or nothing.  Formulation 8, step 8; manual page, comment 15; as built: D07.
std::optional<ConditionFault> filter_fault(int ifiltr, double xfreq);

}  // namespace type21
