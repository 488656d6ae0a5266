/// @file Damping of the tool's own motion (page comment 19, formulation section 9).
#pragma once

#include <cmath>

#include <Eigen/Eigenvalues>

#include "reference/contract/vector.h"

namespace type21::reference {

/// C = 2 share sqrt(inertia * stiffness): the share of the critical damping of the tool on its contact.
/// @param share      Damp, or Dampr for the rotation [-]
/// @param inertia    M, mass of the tool [mass], or I, its smallest principal inertia [mass length^2]
/// @param stiffness  sum of k [force/length], or of k |X - x_G|^2 [moment]
/// @manual field Damp, Dampr; comment 19; departure D13
inline double tool_damping_coefficient(double share, double inertia, double stiffness) {
    return 2.0 * share * std::sqrt(inertia * stiffness);
}

/// Force on the tool: -C (V - V_ref); its opposite acts on the tool of IDref. V_ref = 0 without IDref. Torque likewise.
/// @manual field IDref; comment 19
inline Vec3 tool_damping(double coefficient, const Vec3& velocity, const Vec3& reference_velocity) {
    return -coefficient * (velocity - reference_velocity);
}

}  // namespace type21::reference
