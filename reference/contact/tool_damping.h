/// @file Damping of the tool's own motion (Formulation 9, step 16).
#pragma once

#include <cmath>

#include "reference/contract/rigid_body.h"
#include "reference/contract/vector.h"

namespace type21::reference {

/// Sums over the nodes in contact that a whole tool feels.
struct ToolStiffness {
    double translation = 0;  ///< of k [force/length]
    double rotation = 0;     ///< of k |X - x_G|^2 [moment]
};

/// Stiffness on which the tool is damped: the sum of k.
/// @param contact  of k
/// @param step     of k + C/dt1.  Formulation 9, step 16; as built: D13.
inline ToolStiffness tool_damping_stiffness(const ToolStiffness& contact, [[maybe_unused]] const ToolStiffness& step) {
    return contact;
}

/// Inertia on which the rotation of a tool is damped: about the axis of its spin.
/// @param rotation  R, from the axes of time 0 to global ones [-]
/// @param spin      Omega - Omega_ref, global axes; 0: no axis and no moment [1/time]
/// @return I = <u, R I_0 R^T u>, u along the spin; 0 without a spin [mass length^2].  Formulation 9, step 16; as
/// built: D40.
/// @manual field Dampr; comment 19
inline double damped_inertia(const RigidBody& tool, const Mat3& rotation, const Vec3& spin) {
    return inertia_about(tool.inertia, rotation.transpose() * spin);
}

/// C = 2 share sqrt(inertia * stiffness): the share of the critical damping of the tool on its contact.
/// @param share      Damp, or Dampr for the rotation [-]
/// @param inertia    M, mass of the tool [mass], or I of damped_inertia() [mass length^2]
/// @param stiffness  sum of k [force/length], or of k |X - x_G|^2 [moment]
/// @return C [force time/length], or [moment time] for the rotation.  Formulation 9, step 16.
/// @manual field Damp, Dampr; comment 19
inline double tool_damping_coefficient(double share, double inertia, double stiffness) {
    return 2.0 * share * std::sqrt(inertia * stiffness);
}

/// Force on the tool: -C (V - V_ref); its opposite acts on the tool of IDref. V_ref = 0 without IDref. The moment
/// likewise.
/// @param coefficient  C [force time/length], or [moment time] with angular velocities
/// @return [force] or [moment].  Formulation 9, step 16; manual page, comment 19.
/// @manual field IDref; comment 19
inline Vec3 tool_damping(double coefficient, const Vec3& velocity, const Vec3& reference_velocity) {
    return -coefficient * (velocity - reference_velocity);
}

}  // namespace type21::reference
