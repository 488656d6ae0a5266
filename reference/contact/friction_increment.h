/// @file Incremental friction (Formulation 8, step 9 to step 12).
#pragma once

#include "reference/contract/vector.h"

namespace type21::reference {

/// Friction of one node in one cycle, global axes.
struct FrictionForce {
    Vec3 force = Vec3::Zero();  ///< F_t, on the tool [force]
    Vec3 trial = Vec3::Zero();  ///< T [force]
    bool slips = false;         ///< the limit was reached
};

/// T = F_old + alpha k v dt1, projected on the plane normal to nu, the old force with it;
/// F_t = T min(1, limit / |T|), 0 where T = 0.
/// @param old        F_t of the cycle before, global axes [force]
/// @param stiffness  alpha k of the increment [force/length]
/// @param velocity   v of the node relative to the tool at X [velocity]
/// @param step       dt1 [time]
/// @param normal     nu [-]
/// @param limit      the smaller of mu |F_n| and what Pmax allows; a negative one turns the force round [force]
/// @return F_t and T [force].  Formulation 8, step 9; Formulation 8, step 10; manual page, comment 14, equation (12).
/// @manual eq 12; comment 14
inline FrictionForce friction_force(const Vec3& old, double stiffness, const Vec3& velocity, double step,
                                    const Vec3& normal, double limit) {
    Vec3 trial = old + velocity * (stiffness * step);
    trial -= normal * trial.dot(normal);
    const double size = trial.norm();
    if (size <= limit || size == 0) return {trial, trial, false};
    return {trial * (limit / size), trial, true};
}

/// Energy that slip dissipates in this cycle: q = <T - F_t, F_t> / k, equation (19) without its factor Fheat.
/// @param stiffness  k of the increment [force/length], 0: no increment, no slip
/// @return q [energy].  Formulation 8, step 12; manual page, comment 18, equation (19).
/// @manual eq 19; field Fheat; comment 18
inline double slip_energy(const FrictionForce& friction, double stiffness) {
    return stiffness > 0 ? (friction.trial - friction.force).dot(friction.force) / stiffness : 0.0;
}

}  // namespace type21::reference
