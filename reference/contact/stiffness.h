/// @file Stiffness of a node, normal and tangential (Formulation 7, step 1; Formulation 8, step 9).
#pragma once

#include <algorithm>

#include "reference/contract/scene.h"

namespace type21::reference {

/// k = Stfac S between Stmin and Stmax for Istf 0, k = Stfac for Istf 1.
/// @param interface          its card; Stmin <= Stmax [force/length]
/// @param element_stiffness  S, mean of E t over the shells at the node, >= 0 [force/length]
/// @return k [force/length], >= 0.  Formulation 7, step 1; as built: D01.
/// @manual field Istf, Stfac, Stmin, Stmax; comment 6, 11
inline double nodal_stiffness(const Interface& interface, double element_stiffness) {
    if (interface.istf == 1) return interface.stfac;
    return std::clamp<double>(interface.stfac * element_stiffness, interface.stmin, interface.stmax);
}

/// Stiffness of the friction increment: k, the same as normal to the surface.
/// @param stiffness  k [force/length]
/// @return [force/length].  Formulation 8, step 9; as built: D04, which needs the card and S.
inline double friction_stiffness(const Interface& /*interface*/, double stiffness, double /*element_stiffness*/) {
    return stiffness;
}

}  // namespace type21::reference
