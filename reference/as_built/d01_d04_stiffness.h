/// @file D01, D04: stiffness of a node, normal and tangential.
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference::as_built {

/// As documented: k = Stfac S between Stmin and Stmax for Istf 0.
/// As built: k = Stfac S; Stmin and Stmax are read and never applied.
/// @param element_stiffness  S, mean of E t over the shells at the node [force/length]
/// @return k [force/length].  Formulation 12, step 2; Formulation 7, step 1.
/// @manual departure D01
inline double nodal_stiffness(const Interface& interface, double element_stiffness) {
    return interface.istf == 1 ? interface.stfac : interface.stfac * element_stiffness;
}

/// As documented: the friction increment has the stiffness k.
/// As built: S without Stfac, and for Istf 1 the number 1 in the units of the deck.
/// @param element_stiffness  S [force/length]
/// @return [force/length].  Formulation 12, step 2; Formulation 8, step 9.
/// @manual departure D04
inline double friction_stiffness(const Interface& interface, double /*stiffness*/, double element_stiffness) {
    return interface.istf == 1 ? 1.0 : element_stiffness;
}

}  // namespace type21::reference::as_built
