/// @file D08: the temperature at which fct_IDF is taken.
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference::as_built {

/// As documented: AscaleF (T_s + T_m) / 2, with T_m of the tool at the contact point.
/// As built: (T_s + Tint) / 2, and AscaleF is not used.
/// @param blank  T_s [temperature]
/// @return abscissa of fct_IDF.  Formulation 12, step 2; Formulation 8, step 3.
/// @manual departure D08
inline double friction_temperature(const Interface& interface, double blank, double /*tool*/) {
    return 0.5 * (blank + interface.tint);
}

}  // namespace type21::reference::as_built
