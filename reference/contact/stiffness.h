/// @file Nodal stiffness (page: Istf, Stfac, Stmin, Stmax; formulation section 7).
#pragma once

#include <algorithm>

#include "reference/contract/scene.h"

namespace type21::reference {

/// k = Stfac S between Stmin and Stmax for Istf 0, k = Stfac for Istf 1.
/// @param element_stiffness  S, mean of E t over the shells at the node [force/length]
/// @return k [force/length]
/// @manual field Istf, Stfac, Stmin, Stmax; comment 6, 11; departure D01
inline double nodal_stiffness(const Interface& interface, double element_stiffness, const AsBuilt& as_built) {
    if (interface.istf == 1) return interface.stfac;
    const double k = interface.stfac * element_stiffness;
    if (as_built.has(Departure::D01)) return k;  // bounds are read and never applied
    return std::clamp<double>(k, interface.stmin, interface.stmax);
}

/// Stiffness of the friction increment: k, the same as normal to the surface.
/// D04: S without Stfac, and 1.0 in the units of the deck for Istf 1.
/// @manual departure D04
inline double friction_stiffness(const Interface& interface, double stiffness, double element_stiffness,
                                 const AsBuilt& as_built) {
    if (!as_built.has(Departure::D04)) return stiffness;
    return interface.istf == 1 ? 1.0 : element_stiffness;
}

}  // namespace type21::reference
