/// @file Elastic force, its energy and its damping (Formulation 7, step 2 to step 7).
#pragma once

#include <cmath>

namespace type21::reference {

/// F = k p
/// @param stiffness    k, >= 0 [force/length]
/// @param penetration  p, >= 0 [length]
/// @return F [force], >= 0.  Formulation 7, step 2.
inline double elastic_force(double stiffness, double penetration) {
    return stiffness * penetration;
}

/// E = k p^2 / 2, the integral of F dp
/// @param stiffness    k, >= 0 [force/length]
/// @param penetration  p, >= 0 [length]
/// @return E [energy], >= 0.  Formulation 7, step 4; as built: D05.
inline double elastic_energy(double stiffness, double penetration) {
    return 0.5 * stiffness * penetration * penetration;
}

/// C = VISs sqrt(2 k m)
/// @param viss       VISs, share of the critical damping [-]
/// @param stiffness  k, >= 0 [force/length]
/// @param mass       m, lumped mass of the node, >= 0 [mass]
/// @return C [force time/length].  Formulation 7, step 6.
/// @manual field VISs
inline double damping_coefficient(double viss, double stiffness, double mass) {
    return viss * std::sqrt(2.0 * stiffness * mass);
}

/// Stiffness handed to the time step: k + C/dt1, and k where dt1 = 0.
/// @param stiffness  k [force/length]
/// @param damping    C [force time/length]
/// @param step       dt1, >= 0 [time]
/// @return [force/length].  Formulation 7, step 7.
inline double step_stiffness(double stiffness, double damping, double step) {
    return step > 0 ? stiffness + damping / step : stiffness;
}

}  // namespace type21::reference
