// One secondary node in one cycle, in the order of the formulation.
#include <cmath>

#include "reference/contact/normal_force.h"
#include "reference/cycle/contact_state.h"

namespace type21::reference {

NodeContact Contact::State::node_step(int i, const Motion& motion, ContactStep& step) {
    const auto n = static_cast<size_t>(i);
    const NodeConstants& node = nodes[n];
    PenetrationHistory& history = offsets[n];
    const int model_node = card().secondary.node[n];
    const Vec3& position = motion.position[static_cast<size_t>(model_node)];
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card().tool)];
    const bool time_zero = motion.time <= 0;

    NodeContact out;
    out.gap = node.gap;
    if (skid_line) out.skid = skid_line->largest(i);
    const auto forget = [&] {
        history = {};
        if (friction) friction->forget(i);
    };
    const auto leave = [&] {
        if (!time_zero) forget();
        return out;
    };

    // Sections 1, 3, 4, 5: where the node is, what it touches and how deep.
    if (node.stiffness == 0 && !heat_exchange) return out;
    if (deletion && deletion->deleted(i, motion.thickness)) return leave();
    const Vec3 y = pose.rotation.transpose() * (position - pose.position);
    const LocatedImpact touch = this->touch(i, y, position, pose);
    out.decision = touch.decision;
    if (touch.decision.kind == Kind::none) return leave();
    out.distance = touch.geometry.distance;
    out.normal = pose.rotation * touch.geometry.normal;
    out.point = pose.position + pose.rotation * touch.geometry.point;
    // D11: a proximity node nearer than its gap has force, without a count and without an offset.
    const bool in_contact = touch.decision.kind == Kind::contact;
    const bool has_force = node.stiffness != 0 && (in_contact || as_built(Departure::D11));
    if (has_force) out.geometric_penetration = touch.penetration;
    if (!in_contact && history.cycles > 0) forget();
    if (out.geometric_penetration == 0) {
        if (time_zero && has_force && in_contact && as_built(Departure::D33))
            history.cycles = 1;  // being retained counts
        if (!time_zero || history.cycles == 0) {
            if (!time_zero) forget();
            heat(i, motion, out, step);
            return out;
        }
    } else if (in_contact) {
        ++history.cycles;
    }

    // Section 6: the offset, and whether the stiffness acts.
    const bool first_cycle = history.cycles == 1;
    if (first_cycle && !time_zero) history.offset = out.geometric_penetration;
    if (first_cycle && has(Effect::normals_test) && out.geometric_penetration > node.gap + 0.99 * card().depth) {
        step.inverted.push_back({model_node, touch.decision.segment, out.geometric_penetration});
    }
    history.offset = relaxed_offset(history.offset, inacti, out.geometric_penetration, node.gap);
    out.offset = history.offset;
    out.penetration = effective_penetration(out.geometric_penetration, history.offset);
    const bool acts = stiffness_acts(out.penetration, history.cycles, inacti, time_zero);
    out.stiffness = acts ? node.stiffness : 0.0;
    if (release && release->now(i, out.penetration)) step.released.push_back(model_node);

    normal_force(i, motion, out);
    friction_force(i, motion, acts, out);
    out.force = out.normal_force * out.normal - out.friction;
    heat(i, motion, out, step);
    return out;
}

// Section 7.
void Contact::State::normal_force(int i, const Motion& motion, NodeContact& out) const {
    const auto n = static_cast<size_t>(i);
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card().tool)];
    const Vec3& node_velocity = motion.velocity[static_cast<size_t>(card().secondary.node[n])];
    const Vec3 arm = out.point - pose.position;
    out.relative_velocity = node_velocity - (pose.velocity + pose.angular_velocity.cross(arm));
    if (has(Effect::pmax_limit)) {
        const PmaxLimit limit = pmax_limit(i);
        out.elastic_force = limited_force(out.stiffness, out.penetration, limit);
        out.elastic_energy = limited_energy(out.stiffness, out.penetration, limit);
    } else {
        out.elastic_force = elastic_force(out.stiffness, out.penetration);
        out.elastic_energy = elastic_energy(out.stiffness, out.penetration);
    }
    if (as_built(Departure::D05) && card().istf == 1 && card().igap != 2) {
        out.elastic_energy = elastic_energy_as_built(card().stfac, out.stiffness, out.penetration);
    }
    if (has(Effect::damping)) out.damping = damping_coefficient(card().viss, out.stiffness, nodes[n].mass);
    out.normal_force = out.elastic_force - out.damping * out.relative_velocity.dot(out.normal);
    out.step_stiffness = step_stiffness(out.stiffness, out.damping, motion.step);
}

// Section 8.
void Contact::State::friction_force(int i, const Motion& motion, bool acts, NodeContact& out) {
    if (acts) out.status = Status::slip;
    if (!friction) return;
    FrictionInput input;
    input.normal_force = out.normal_force;
    input.stiffness = acts ? nodes[static_cast<size_t>(i)].friction_stiffness : 0.0;
    input.step = motion.friction_step;
    input.part_main = part_of_segment(out.decision.segment);
    input.velocity = out.relative_velocity;
    input.normal = out.normal;
    if (has(Effect::pmax_limit) && card().itlim == 0) input.cap = tangential_limit(pmax_limit(i).pressure_force);
    if (has(Effect::friction_heat_factor)) {
        // D08: Tint always, and AscaleF unused.
        const bool d08 = as_built(Departure::D08);
        const double blank = motion.temperature[static_cast<size_t>(card().secondary.node[static_cast<size_t>(i)])];
        const double tool_side = d08 ? double(card().tint) : tool_temperature(out.decision, motion);
        const double mean = 0.5 * (blank + tool_side);
        input.temperature_factor =
            model->functions[static_cast<size_t>(card().function_friction)](d08 ? mean : card().ascalef * mean);
    }
    const FrictionForce tangential = friction->act(i, input);
    out.friction = tangential.force;
    out.status = tangential.slips ? Status::slip : Status::stick;
    if (heat_exchange) out.friction_heat = card().fheat * slip_energy(tangential, input.stiffness);
    if (skid_line) {
        const double area = card().secondary.area[static_cast<size_t>(i)];
        out.skid = skid_line->record(i, skid_ratio(tangential.slips, out.friction.norm(), card().pskid, area));
    }
}

// Section 9, heat.
void Contact::State::heat(int i, const Motion& motion, NodeContact& out, ContactStep& step) const {
    if (!heat_exchange) return;
    HeatInput input;
    input.distance = out.distance;
    input.gap = out.gap;
    input.normal_force = out.normal_force;
    input.step = motion.step;
    input.blank_temperature = motion.temperature[static_cast<size_t>(card().secondary.node[static_cast<size_t>(i)])];
    input.tool_temperature = tool_temperature(out.decision, motion);
    const HeatFlow flow = heat_exchange->flow(i, input);
    out.conductance = flow.conductance;
    out.heat = flow.heat + out.friction_heat;
    if (!heat_exchange->heats_tool()) return;
    // The tool gives what the blank gets from it. D16: the friction heat goes to the tool as well, in full.
    const double to_tool = -flow.heat + (as_built(Departure::D16) ? out.friction_heat : 0.0);
    const auto& corner = surface.nodes(out.decision.segment);
    const double a = 1.0 - out.decision.b - out.decision.c;
    if (corner[2] == corner[3]) {
        step.tool_heat.push_back({corner[2], a * to_tool});
        step.tool_heat.push_back({corner[0], out.decision.b * to_tool});
        step.tool_heat.push_back({corner[1], out.decision.c * to_tool});
        return;
    }
    for (const int node : corner)
        step.tool_heat.push_back({node, 0.25 * a * to_tool});
    step.tool_heat.push_back({corner[static_cast<size_t>(out.decision.triangle - 1)], out.decision.b * to_tool});
    step.tool_heat.push_back({corner[static_cast<size_t>(out.decision.triangle % 4)], out.decision.c * to_tool});
}

double Contact::State::tool_temperature(const Decision& decision, const Motion& motion) const {
    if (!heat_exchange || !heat_exchange->tool_has_temperatures()) return card().tint;
    const auto& corner = surface.nodes(decision.segment);
    const auto at = [&](int j) { return motion.temperature[static_cast<size_t>(corner[static_cast<size_t>(j)])]; };
    const double a = 1.0 - decision.b - decision.c;
    if (corner[2] == corner[3]) return a * at(2) + decision.b * at(0) + decision.c * at(1);
    const double center = 0.25 * (at(0) + at(1) + at(2) + at(3));
    return a * center + decision.b * at(decision.triangle - 1) + decision.c * at(decision.triangle % 4);
}

PmaxLimit Contact::State::pmax_limit(int i) const {
    const auto n = static_cast<size_t>(i);
    const SecondarySide& side = card().secondary;
    return {std::max(nodes[n].gap - side.gap[n], 0.0), side.area[n] * card().pmax};
}

}  // namespace type21::reference
