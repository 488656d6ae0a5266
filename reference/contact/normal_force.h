/// @file Normal force, its damping and its energy (page comment 5, formulation section 7).
#pragma once

#include <cmath>

namespace type21::reference {

/// F = k p
/// @param stiffness    k [force/length]
/// @param penetration  p >= 0 [length]
inline double elastic_force(double stiffness, double penetration) {
    return stiffness * penetration;
}

/// Integral of F dp: k p^2 / 2 [energy]
inline double elastic_energy(double stiffness, double penetration) {
    return 0.5 * stiffness * penetration * penetration;
}

/// D05, Istf 1 with Igap 0 or 1: Stfac raised to the power p^2 for each node whose k is not 0. Its value has no
/// dimension.
/// @manual departure D05
inline double elastic_energy_as_built(double stfac, double stiffness, double penetration) {
    return stiffness != 0 ? std::pow(stfac, penetration * penetration) : 0.0;
}

/// C = VISs sqrt(2 k m)
/// @param viss       VISs, share of the critical damping [-]
/// @param stiffness  k [force/length]
/// @param mass       m, lumped mass of the node [mass]
/// @return C [force time/length]
/// @manual field VISs
inline double damping_coefficient(double viss, double stiffness, double mass) {
    return viss * std::sqrt(2.0 * stiffness * mass);
}

/// Stiffness handed to the time step: k + C/dt1, and k where dt1 = 0 [force/length]
inline double step_stiffness(double stiffness, double damping, double step) {
    return step > 0 ? stiffness + damping / step : stiffness;
}

}  // namespace type21::reference
