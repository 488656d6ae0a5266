/// @file D11: a proximity that competes with contacts and has force.
#pragma once

#include <algorithm>

#include "reference/contact/contact_reading.h"

namespace type21::reference::as_built {

/// As documented: Drad is a reach of the search only where Frad is given.
/// As built: always with heat exchange.
/// @return reach of a proximity [length], 0 without heat.  Formulation 12, step 2; Formulation 9, step 5.
/// @manual departure D11
inline double heat_reach(const Interface& interface) {
    if (interface.ithe == 0) return 0;
    return interface.function_distance >= 0 ? std::max<double>(interface.drad, interface.dcond) : interface.drad;
}

/// As documented: contact comes before proximity, and a proximity gives no force.
/// As built: both compete on kappa alone, a proximity node nearer than its gap has force, without a count of cycles and
/// without an offset, and Drad is a reach of its own.  Formulation 12, step 2; Formulation 4, step 2.
/// @manual departure D11
inline void let_proximity_compete(ContactReading& reading) {
    reading.impact.proximity_competes = true;
    reading.proximity_has_force = true;
    reading.heat_reach = heat_reach;
}

}  // namespace type21::reference::as_built
