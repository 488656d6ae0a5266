// One secondary node in one cycle, chapter by chapter. A law that is taken from `reading` has an as-built counterpart
// in reference/as_built; without departures it is the law of the same name in reference/contact.
#include <algorithm>
#include <cmath>

#include "reference/contact/normal_force.h"
#include "reference/cycle/contact_state.h"

namespace type21::reference {

// @manual field Invn; comment 21
NodeContact Contact::State::node_step(int i, const Motion& motion, ContactStep& step) {
    const auto n = static_cast<size_t>(i);
    const NodeConstants& node = nodes[n];
    PenetrationHistory& history = offsets[n];
    const ToolMotion& tool_pose = pose(motion);
    const bool time_zero = motion.time <= 0;

    NodeContact out;
    out.gap = node.gap;                                   // Formulation 2, step 4; Formulation 2, step 5
    if (skid_line) step.skid[n] = skid_line->largest(i);  // Formulation 9, step 14
    const auto leave = [&] {
        if (!time_zero) forget(i);
        return out;
    };
    // Formulation 6, step 1: a node that Inacti 1 has switched off. Formulation 9, step 3: a deleted one.
    if (node.stiffness == 0 && !heat_exchange) return out;
    if (deletion && deletion->deleted(i, motion.thickness)) return leave();

    // Chapters 1 and 3 to 5: where the node is, what it touches and how deep.
    const LocatedImpact impact = locate(i, motion.position[model_node(i)], tool_pose, reading.impact);
    out.decision = impact.decision;
    if (impact.decision.kind == Kind::none) return leave();
    out.point = tool_pose.position + tool_pose.rotation * impact.geometry.point;
    out.normal = tool_pose.rotation * impact.geometry.normal;
    out.distance = impact.geometry.distance;
    const bool in_contact = impact.decision.kind == Kind::contact;
    const bool can_have_force = node.stiffness != 0 && (in_contact || reading.proximity_has_force);
    if (can_have_force) out.geometric_penetration = impact.penetration;

    // Formulation 6, step 5: without an impact there is heat at most.
    if (!count_cycle(i, out, can_have_force, time_zero)) {
        heat(i, motion, out, step);
        return out;
    }

    // Formulation 6, step 2: in the first cycle of a later impact all of the penetration is forgiven.
    const bool first_cycle = history.cycles == 1;
    if (first_cycle && !time_zero) history.offset = out.geometric_penetration;
    // Formulation 7, step 9: test for inverted normals.
    if (first_cycle && has(Effect::normals_test) && out.geometric_penetration > node.gap + 0.99 * card().depth)
        step.inverted.push_back({static_cast<int>(model_node(i)), impact.decision.segment, out.geometric_penetration});
    // Formulation 6, step 3: relaxation and effective penetration.
    history.offset = relaxed_offset(history.offset, inacti, out.geometric_penetration, node.gap);
    out.offset = history.offset;
    out.penetration = effective_penetration(out.geometric_penetration, history.offset);
    // Formulation 6, step 4: whether the stiffness acts.
    const bool acts = stiffness_acts(out.penetration, history.cycles, inacti, time_zero);
    out.stiffness = acts ? node.stiffness : 0.0;

    // Chapters 7 and 8: forces. The node gets the normal force, and the opposite of what friction does to the tool.
    normal_force(i, motion, out);
    friction_force(i, motion, acts, out, step);
    out.force = out.normal_force * out.normal - out.friction;

    // Chapter 9: release of boundary conditions (Formulation 9, step 13) and heat.
    if (release && release->now(i, out.penetration)) step.released.push_back(static_cast<int>(model_node(i)));
    heat(i, motion, out, step);
    return out;
}

void Contact::State::forget(int i) {
    offsets[static_cast<size_t>(i)] = {};
    if (friction) friction->forget(i);
}

bool Contact::State::count_cycle(int i, const NodeContact& node, bool can_have_force, bool time_zero) {
    PenetrationHistory& history = offsets[static_cast<size_t>(i)];
    const bool in_contact = node.decision.kind == Kind::contact;
    if (!in_contact && history.cycles > 0) forget(i);
    if (node.geometric_penetration > 0) {
        if (in_contact) ++history.cycles;
        return true;
    }
    if (!time_zero) {
        forget(i);
        return false;
    }
    if (in_contact && can_have_force && reading.counts_without_penetration) history.cycles = 1;
    return history.cycles > 0;
}

void Contact::State::normal_force(int i, const Motion& motion, NodeContact& out) const {
    const double k = out.stiffness;
    const double p = out.penetration;
    // Formulation 7, step 2 to step 4: elastic force, with its plateau under Pmax, and its energy.
    if (has(Effect::pmax_limit)) {
        const PmaxLimit limit = pmax_limit(i);
        out.elastic_force = limited_force(k, p, limit);
        out.elastic_energy = limited_energy(k, p, limit);
    } else {
        out.elastic_force = elastic_force(k, p);
        out.elastic_energy = reading.elastic_energy(k, p);
    }
    // Formulation 7, step 5: velocity of the node relative to the tool at the contact point.
    const ToolMotion& tool_pose = pose(motion);
    const Vec3 arm = out.point - tool_pose.position;
    const Vec3 tool_velocity = tool_pose.velocity + tool_pose.angular_velocity.cross(arm);
    out.relative_velocity = motion.velocity[model_node(i)] - tool_velocity;
    // Formulation 7, step 6: contact damping.
    if (has(Effect::damping)) out.damping = damping_coefficient(card().viss, k, nodes[static_cast<size_t>(i)].mass);
    // Formulation 7, step 7: normal force, and the stiffness for the time step.
    out.normal_force = out.elastic_force - out.damping * out.relative_velocity.dot(out.normal);
    out.step_stiffness = step_stiffness(k, out.damping, motion.step);
}

PmaxLimit Contact::State::pmax_limit(int i) const {
    const auto n = static_cast<size_t>(i);
    const SecondarySide& side = card().secondary;
    return {std::max(nodes[n].gap - side.gap[n], 0.0), side.area[n] * card().pmax};
}

void Contact::State::friction_force(int i, const Motion& motion, bool acts, NodeContact& out, ContactStep& step) {
    if (acts) out.status = Status::slip;
    if (!friction) return;
    const FrictionInput input = friction_input(i, motion, out, acts);
    // Formulation 8, step 1 to step 7: coefficient.
    const FrictionState state = friction->state(i, input);
    note_friction(i, input, state, step);
    // Formulation 8, step 8 to step 11: filter, trial force, return, memory.
    const FrictionForce tangential = friction->act(i, input, state.coefficient);
    out.friction = tangential.force;
    out.status = tangential.slips ? Status::slip : Status::stick;
    // Formulation 8, step 12: slip energy. Formulation 9, step 10: the share of it that becomes heat.
    const auto n = static_cast<size_t>(i);
    if (heat_exchange) step.heat[n].friction_heat = card().fheat * slip_energy(tangential, input.stiffness);
    // Formulation 9, step 14: skid line.
    if (skid_line) {
        const double area = card().secondary.area[n];
        step.skid[n] = skid_line->record(i, skid_ratio(tangential.slips, out.friction.norm(), card().pskid, area));
    }
}

void Contact::State::note_friction(int i, const FrictionInput& input, const FrictionState& state,
                                   ContactStep& step) const {
    // Formulation 8, step 3: fct_IDF below zero.
    const double scaled = card().fric * input.temperature_factor;
    if (has(Effect::friction_heat_factor) && scaled < 0) {
        FrictionBelowZero& below = step.friction_below_zero;
        if (++below.count == 1) below = {1, static_cast<int>(model_node(i)), input.abscissa, scaled};
    }
    // Formulation 8, step 7: a law that leaves the numbers of a double.
    if (std::isfinite(state.coefficient) || !std::isfinite(state.pressure) || !std::isfinite(state.speed)) return;
    FrictionOverflow& overflow = step.friction_overflow;
    if (++overflow.count > 1) return;
    const FrictionCoefficients numbers = friction_coefficients(*model, card(), friction->part(i), input.part_main);
    const size_t rank = overflowing_coefficient(card().ifric, numbers, state.speed);
    overflow = {
        1, static_cast<int>(model_node(i)), static_cast<int>(rank), numbers.c.at(rank), state.speed, state.pressure};
}

FrictionInput Contact::State::friction_input(int i, const Motion& motion, const NodeContact& node, bool acts) const {
    FrictionInput input;
    input.normal_force = node.normal_force;
    input.stiffness = acts ? nodes[static_cast<size_t>(i)].friction_stiffness : 0.0;
    input.step = motion.friction_step;
    input.part_main = part_of_segment(node.decision.segment);
    input.velocity = node.relative_velocity;
    input.normal = node.normal;
    // Formulation 8, step 10: the limit of Pmax.
    if (has(Effect::pmax_limit) && card().itlim == 0) input.cap = tangential_limit(pmax_limit(i).pressure_force);
    // Formulation 8, step 3: the temperature.
    if (has(Effect::friction_heat_factor)) {
        const Function& function = model->functions[static_cast<size_t>(card().function_friction)];
        const double blank = motion.temperature[model_node(i)];
        const double tool = tool_temperature(node.decision, motion);
        input.abscissa = reading.friction_temperature(card(), blank, tool);
        input.temperature_factor = function(input.abscissa);
    }
    return input;
}

}  // namespace type21::reference
