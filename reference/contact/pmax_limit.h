/// @file Pressure limit of a sheet that thickens (Formulation 7, step 3; Formulation 8, step 10).
#pragma once

#include <algorithm>
#include <cmath>

namespace type21::reference {

/// What limits one node.
struct PmaxLimit {
    double gap_growth = 0;      ///< Delta = max(g - g0, 0) [length]
    double pressure_force = 0;  ///< P_A = A Pmax [force]
};

/// Whether the sheet has grown so far that the limit acts: k Delta > P_A.
/// @param stiffness  k [force/length].  Formulation 7, step 3.
inline bool limited(double stiffness, const PmaxLimit& limit) {
    return stiffness * limit.gap_growth > limit.pressure_force;
}

/// Normal force with Igap 2, equation (5):
///   F = k p                                        while k Delta <= P_A
///   F = k max(p - Delta, 0) + min(P_A, k p)        otherwise: up to P_A, a plateau while p <= Delta, then slope k
///   again
/// @param stiffness    k [force/length]
/// @param penetration  p >= 0 [length]
/// @return F [force], >= 0.  Formulation 7, step 3; manual page, comment 5, equation (5).
/// @manual eq 5; field Pmax; comment 5
inline double limited_force(double stiffness, double penetration, const PmaxLimit& limit) {
    if (!limited(stiffness, limit)) return stiffness * penetration;
    return stiffness * std::max(penetration - limit.gap_growth, 0.0) +
           std::min(limit.pressure_force, stiffness * penetration);
}

/// Integral of that F over p, exact: the part of p that the spring takes is p_s = F / k and carries F p_s / 2; the rest
/// is the plateau, p - p_s at the force P_A.
/// @param stiffness    k [force/length]
/// @param penetration  p >= 0 [length]
/// @return [energy], >= 0.  Formulation 7, step 4.
/// @manual eq 5; field Pmax
inline double limited_energy(double stiffness, double penetration, const PmaxLimit& limit) {
    if (!limited(stiffness, limit)) return 0.5 * stiffness * penetration * penetration;
    const double force = limited_force(stiffness, penetration, limit);
    const double spring = force / stiffness;
    return std::max(penetration - spring, 0.0) * limit.pressure_force + 0.5 * spring * force;
}

/// Largest tangential force, equation (6): A Pmax / sqrt(3), the shear yield of the limit pressure. Only with ITlim 0
/// and Igap 2.
/// @param pressure_force  P_A, >= 0 [force]
/// @return [force].  Formulation 8, step 10; manual page, comment 5, equation (6).
/// @manual eq 6; field ITlim, Pmax; comment 5
inline double tangential_limit(double pressure_force) {
    return pressure_force / std::sqrt(3.0);
}

}  // namespace type21::reference
