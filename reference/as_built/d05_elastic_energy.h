/// @file D05: elastic energy with Istf 1.
#pragma once

#include <cmath>

namespace type21::reference::as_built {

/// As documented: E = k p^2 / 2 [energy].
/// As built, with Istf 1 and Igap 0 or 1: Stfac raised to the power p^2 for each node whose k is not 0. Its value has
/// no dimension.
/// @param stfac        Stfac, taken as a number
/// @param stiffness    k [force/length]
/// @param penetration  p [length]
/// @return written as an energy.  Formulation 12, step 2; Formulation 7, step 4.
/// @manual departure D05
inline double elastic_energy(double stfac, double stiffness, double penetration) {
    return stiffness != 0 ? std::pow(stfac, penetration * penetration) : 0.0;
}

}  // namespace type21::reference::as_built
