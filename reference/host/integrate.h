/// @file One step of nodes and tools: v_{n+1/2} = v_{n-1/2} + a (dt1 + dt2)/2, x_{n+1} = x_n + v_{n+1/2} dt2
/// (Formulation 11, step 4; Formulation 11, step 5).
#pragma once

#include <vector>

#include "reference/host/state.h"
#include "reference/model/host_scene.h"

namespace type21 {

/// Forces of one cycle at t_n. contact and load are apart since a reaction holds against the contact only.
struct CycleForces {
    std::vector<Vec3> contact;      ///< on nodes [force]
    std::vector<Vec3> load;         ///< on nodes, /CLOAD and /GRAV [force]
    std::vector<Vec3> tool_force;   ///< contact and tool damping, per body [force]
    std::vector<Vec3> tool_moment;  ///< about x_G, per body [moment]
    std::vector<Vec3> load_force;   ///< /CLOAD and /GRAV on bodies [force]
    std::vector<Vec3> load_moment;  ///< per body, about x_G [moment]
};

/// All zero, with the sizes of the model.
CycleForces no_forces(const Model& model);

/// Adds the /CLOAD and /GRAV of time t_n, those whose sensor is on.
void add_loads(const Model& model, const HostState& state, CycleForces& forces);

/// Moves everything from t_n to t_{n+1} and sums the reactions of cycle n.
/// @param step  dt2, > 0 [time].  Formulation 11, step 4; Formulation 11, step 5; Formulation 11, step 9.
void advance(const Model& model, const CycleForces& forces, double step, HostState& state);

/// Value of a function at the time that counts for it: the run's, or since its sensor switched on. Nothing while it is
/// off.
struct ImposedValue {
    bool acts = false;
    double value = 0;  ///< [velocity], [length] or [length/time^2], or their angular counterparts
};
/// @param state  of t_n, with its sensors
/// @param at     time of the value itself [time]
ImposedValue imposed_value(const Model& model, const ImposedMotion& motion, const HostState& state, double at);

}  // namespace type21
