/// @file D31: the projection that finds the penetrations of time 0.
#pragma once

#include "reference/contact/contact_reading.h"

namespace type21::reference::as_built {

/// As documented: the first penetration comes from the projection of every cycle.
/// As built: from another one. A weight may be 5 % outside, only the node's own gap reaches (no search gap, no heat, no
/// box of D34), nu is the normal interpolated at the weights (b, c), and delta = <P - X, nu>.
/// @param impact  the reading of every cycle, for what stays the same
/// @return the reading at time 0.  Formulation 12, step 2; Formulation 6, step 1.
/// @manual departure D31
ImpactReading first_impact(const ImpactReading& impact);

}  // namespace type21::reference::as_built
