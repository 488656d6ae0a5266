/// @file D06, D07, D28: the filter factor of the friction increment.
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference::as_built {

/// Which of the three are switched on.
struct FilterDepartures {
    bool d06 = false;
    bool d07 = false;
    bool d28 = false;
};

/// As documented: alpha = min(1, 2 pi Xfreq dt1) for Ifiltr 3, min(1, 2 pi Xfreq) for Ifiltr 2, with Ifiltr and Xfreq
/// of /FRICTION where fric_ID names one. As built: D06, Ifiltr 3: max(1, 2 pi Xfreq dt1), which never filters.
///           D07, Ifiltr 2: 2 pi / Xfreq.
///           D28, with /FRICTION: the factor before the step enters is that of the card's own Ifiltr and Xfreq (1 where
///           they are blank); the Ifiltr of /FRICTION only decides whether the step enters.
/// @param step  dt1 of the friction increment [time]
/// @return alpha [-].  Formulation 12, step 2; Formulation 8, step 8.
/// @manual departure D06, D07, D28
double filter_constant(const FilterDepartures& on, const Interface& interface, double step);

}  // namespace type21::reference::as_built
