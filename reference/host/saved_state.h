/// @file What a checkpoint holds of the march. Every field of these structs is named: one that is added later does not
/// compile until it is decided whether it belongs to a checkpoint.
#pragma once

#include "reference/contract/state_stream.h"
#include "reference/host/march.h"
#include "reference/host/state.h"

namespace type21 {

/// The skew of a condition is of the model.
template <class Archive>
void visit_state(Archive& archive, NodeConditions& node) {
    auto& [fixed, imposed, skew] = node;
    static_cast<void>(skew);
    for (bool& one : fixed)
        archive(one);
    for (int& one : imposed)
        archive(one);
}

template <class Archive>
void visit_state(Archive& archive, BodyState& body) {
    auto& [position, rotation, rotation_before, velocity, angular_velocity, imposed_angle] = body;
    archive(position, rotation.coeffs(), rotation_before.coeffs(), velocity, angular_velocity, imposed_angle);
}

/// Which body a node belongs to is of the model.
template <class Archive>
void visit_state(Archive& archive, HostState& state) {
    auto& [conditions, body, start, position, velocity, acceleration, displacement, angular_velocity, reaction,
           reaction_moment, bodies, thickness, temperature, sensors, last_force, time, step, weight_before, cycle] =
        state;
    archive(conditions, start, position, velocity, acceleration, displacement, angular_velocity, reaction,
            reaction_moment, bodies, thickness, temperature, sensors, last_force, time, step, weight_before, cycle);
}

template <class Archive>
void visit_state(Archive& archive, InterfaceTotals& totals) {
    auto& [normal, tangential, abs_normal, signed_normal, abs_total, norm_total, friction_heat, elastic_energy,
           friction_energy, damping_energy, heat_to_blank, heat_to_tool] = totals;
    archive(normal, tangential, abs_normal, signed_normal, abs_total, norm_total, friction_heat, elastic_energy,
            friction_energy, damping_energy, heat_to_blank, heat_to_tool);
}

}  // namespace type21
