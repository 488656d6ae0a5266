/// @file Incremental friction (page comments 14, 15, equations (12) and (13); formulation section 8).
#pragma once

#include "reference/model/vector.h"

namespace type21::reference {

struct FrictionForce {
    Vec3 force = Vec3::Zero();  ///< F_t, on the tool [force]
    bool slips = false;         ///< the limit was reached
};

/// T = F_old + k v dt1, projected on the plane normal to nu, the old force with it;   F_t = T min(1, limit / |T|), 0
/// where T = 0.
/// @param old        F_t of the cycle before, global axes [force]
/// @param stiffness  k of the increment [force/length]
/// @param velocity   v of the node relative to the tool at X [velocity]
/// @param step       dt1 [time]
/// @param normal     nu [-]
/// @param limit      mu |F_n| [force]
inline FrictionForce friction_force(const Vec3& old, double stiffness, const Vec3& velocity, double step,
                                    const Vec3& normal, double limit) {
    Vec3 trial = old + velocity * (stiffness * step);
    trial -= normal * trial.dot(normal);
    const double size = trial.norm();
    if (size <= limit || size == 0) return {trial, false};
    return {trial * (limit / size), true};
}

}  // namespace type21::reference
