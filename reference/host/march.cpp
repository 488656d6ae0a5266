#include "reference/host/march.h"

#include <cmath>

#include <fmt/format.h>

#include "reference/host/integrate.h"
#include "reference/host/saved_state.h"
#include "reference/host/shell_conduction.h"
#include "reference/host/time_step.h"

namespace type21 {

namespace {

/// Inacti 3: the node is moved out along nu until delta = g. The projection changes a little as the node moves, so this
/// is repeated.  Formulation 6, step 1.
/// @manual field Inacti; comment 8
void move_out_initial_penetrations(const HostScene& scene, const std::vector<std::unique_ptr<ContactMethod>>& contacts,
                                   HostState& state) {
    constexpr int rounds = 20;
    for (size_t i = 0; i < contacts.size(); ++i) {
        if (scene.model->interfaces[i].inacti != 3) continue;
        for (int round = 0; round < rounds; ++round) {
            const auto found = contacts[i]->initial_penetrations(state.start);
            if (found.empty()) break;
            for (const InitialPenetration& p : found)
                state.start[static_cast<size_t>(p.node)] += p.penetration * p.normal;
        }
        state.position = state.start;
    }
}

CycleForces forces_of(const Model& model, const HostState& state, const std::vector<ContactStep>& steps) {
    CycleForces forces = no_forces(model);
    for (size_t i = 0; i < steps.size(); ++i) {
        if (!steps[i].active) continue;
        const Interface& interface = model.interfaces[i];
        for (size_t n = 0; n < steps[i].nodes.size(); ++n) {
            forces.contact[static_cast<size_t>(interface.secondary.node[n])] += steps[i].nodes[n].force;
        }
        const ToolLoad& load = steps[i].tool;
        const auto tool = static_cast<size_t>(interface.tool);
        forces.tool_force[tool] += load.force + load.damping_force;
        forces.tool_moment[tool] += load.moment + load.damping_moment;
        if (interface.reference_interface >= 0) {
            const auto other =
                static_cast<size_t>(model.interfaces[static_cast<size_t>(interface.reference_interface)].tool);
            forces.tool_force[other] -= load.damping_force;
            forces.tool_moment[other] -= load.damping_moment;
        }
    }
    add_loads(model, state, forces);
    return forces;
}

/// @param weight  of the impulses [time].  Formulation 11, step 7; Formulation 11, step 8.
void add_totals(const ContactSums& sums, double weight, InterfaceTotals& totals) {
    totals.normal += sums.normal * weight;
    totals.tangential += sums.tangential * weight;
    totals.abs_normal += sums.abs_normal * weight;
    totals.signed_normal += sums.signed_normal * weight;
    totals.abs_total += sums.abs_total * weight;
    totals.norm_total += sums.norm_total * weight;
    totals.friction_heat += sums.friction_heat;
    totals.friction_energy += sums.friction_work - sums.friction_heat;
    totals.damping_energy += sums.damping_work;
    totals.heat_to_blank += sums.heat_to_blank;
    totals.heat_to_tool += sums.heat_to_tool;
    totals.elastic_energy = sums.elastic_energy;
}

/// T += heat / (nodal heat capacity); a node without capacity keeps its temperature.  Formulation 9, step 12.
void heat_nodes(const Model& model, const std::vector<ContactStep>& steps, const std::vector<double>& inside,
                HostState& state) {
    if (state.temperature.empty() || model.nodal_heat_capacity.empty()) return;
    const auto give = [&](int node, double heat) {
        const auto n = static_cast<size_t>(node);
        const double capacity = model.nodal_heat_capacity[n];
        if (capacity > 0) state.temperature[n] += heat / capacity;
    };
    for (size_t n = 0; n < inside.size(); ++n) {
        if (inside[n] != 0) give(static_cast<int>(n), inside[n]);
    }
    for (size_t i = 0; i < steps.size(); ++i) {
        const auto& nodes = model.interfaces[i].secondary.node;
        for (size_t n = 0; n < steps[i].nodes.size(); ++n) {
            if (steps[i].nodes[n].heat != 0) give(nodes[n], steps[i].nodes[n].heat);
        }
        for (const ToolHeat& heat : steps[i].tool_heat)
            give(heat.node, heat.heat);
    }
}

/// @manual field IBC; comment 7
void release(const Model& model, const std::vector<ContactStep>& steps, HostState& state) {
    for (size_t i = 0; i < steps.size(); ++i) {
        const int ibc = model.interfaces[i].ibc;
        for (const int node : steps[i].released) {
            for (int d = 0; d < 3; ++d) {
                if ((ibc & (4 >> d)) != 0)
                    state.conditions[static_cast<size_t>(node)].fixed[static_cast<size_t>(d)] = false;
            }
        }
    }
}

std::string when(const HostState& state, const UnitSystem& units) {
    return fmt::format("in cycle {} at t = {:.9g} {}", state.cycle, state.time, units.name(dim::time));
}

void check_step(const Model& model, const HostState& state, double step) {
    if (std::isfinite(step) && step > 0) {
        if (step < model.engine.smallest_step) {
            throw RunStopped(RunStopped::Why::step_too_small,
                             fmt::format("the time step {:.6g} {unit} is below the smallest of /DT, {:.6g} {unit}, {}",
                                         step, model.engine.smallest_step, when(state, model.units),
                                         fmt::arg("unit", model.units.name(dim::time))));
        }
        return;
    }
    throw RunStopped(
        RunStopped::Why::diverged,
        fmt::format("the time step is {} {}, {}: nothing limits it; give a step by /DTIX or an interval by /TFILE",
                    step, model.units.name(dim::time), when(state, model.units)));
}

void check_finite(const Model& model, const HostState& state, const std::vector<ContactStep>& steps) {
    const auto stop = [&](const char* what, int node) {
        throw RunStopped(RunStopped::Why::diverged,
                         fmt::format("the {} of node {} is not finite, {}", what,
                                     model.nodes.id[static_cast<size_t>(node)], when(state, model.units)));
    };
    for (size_t i = 0; i < steps.size(); ++i) {
        for (size_t n = 0; n < steps[i].nodes.size(); ++n) {
            if (!steps[i].nodes[n].force.allFinite()) stop("contact force", model.interfaces[i].secondary.node[n]);
        }
    }
    for (size_t n = 0; n < state.position.size(); ++n) {
        if (!state.position[n].allFinite()) stop("position", static_cast<int>(n));
        if (!state.velocity[n].allFinite()) stop("velocity", static_cast<int>(n));
        if (!state.temperature.empty() && !std::isfinite(state.temperature[n]))
            stop("temperature", static_cast<int>(n));
    }
}

/// @manual field Invn; comment 21
void check_normals(const Model& model, const HostState& state, const std::vector<ContactStep>& steps) {
    for (size_t i = 0; i < steps.size(); ++i) {
        if (steps[i].inverted.empty()) continue;
        const InvertedNormal& first = steps[i].inverted.front();
        const Interface& interface = model.interfaces[i];
        const Segment& segment =
            model.surfaces[static_cast<size_t>(interface.main_surface)].segments[static_cast<size_t>(first.segment)];
        std::string nodes;
        for (int j = 0; j < segment.corners(); ++j) {
            nodes += fmt::format("{}{}", j > 0 ? " " : "",
                                 model.nodes.id[static_cast<size_t>(segment.node[static_cast<size_t>(j)])]);
        }
        throw RunStopped(
            RunStopped::Why::inverted_normal,
            fmt::format("Invn of interface {}: the first impact of node {} came from behind, {}: penetration {:.9g} {} "
                        "on segment {} "
                        "(nodes {}); {} node{} in this cycle; check that the main normals face the blank",
                        interface.id, model.nodes.id[static_cast<size_t>(first.node)], when(state, model.units),
                        first.penetration, model.units.name(dim::length), first.segment + 1, nodes,
                        steps[i].inverted.size(), steps[i].inverted.size() == 1 ? "" : "s"));
    }
}

}  // namespace

void march(const HostScene& scene, const MakeContact& make_contact, const Observer& observe,
           const MarchOptions& options) {
    const Model& model = *scene.host;
    const HostReading reading = host_reading(model.as_built);
    std::vector<std::unique_ptr<ContactMethod>> contacts;
    contacts.reserve(model.interfaces.size());
    for (int i = 0; i < static_cast<int>(model.interfaces.size()); ++i)
        contacts.push_back(make_contact(scene, i));
    HostState state(model);
    if (options.restart == nullptr) move_out_initial_penetrations(scene, contacts, state);
    TimeStep time_step(scene);
    std::vector<InterfaceTotals> totals(contacts.size());

    if (options.thickness != nullptr) {
        for (const Shell& shell : model.shells)
            state.thickness.push_back(shell.thickness);
    }

    // All that one cycle leaves to the next: what is added to the march is added here, too.
    const auto remembered = [&](auto& archive) { archive(state, time_step, totals); };
    const std::function<void(StateWriter&)> save = [&](StateWriter& out) {
        remembered(out);
        for (const auto& contact : contacts)
            contact->save(out);
    };
    if (options.restart != nullptr) {
        remembered(*options.restart);
        for (const auto& contact : contacts)
            contact->restore(*options.restart);
    }
    const long first_cycle = state.cycle;

    // Two states take turns and the steps are used again, so that no cycle allocates memory of their size.
    HostState next = state;
    std::vector<ContactStep> steps(contacts.size());
    while (state.time <= model.engine.end_time) {
        if (options.between_cycles && state.cycle > first_cycle)
            options.between_cycles({state.cycle, state.time, save});
        // Formulation 11, step 2: contact, time step, sums, motion, heat, output.
        state.impose_temperatures(model);
        const Motion motion = state.motion(reading);
        for (size_t i = 0; i < contacts.size(); ++i)
            contacts[i]->step_into(motion, steps[i]);
        check_finite(model, state, steps);
        const double step = time_step.next(state, steps);
        check_step(model, state, step);

        const double weight = reading.impulse_weight({state.step, 0.5 * (state.step + step), state.weight_before});
        for (size_t i = 0; i < totals.size(); ++i)
            add_totals(steps[i].sums, weight, totals[i]);

        // The record of cycle n holds x_n and v_{n-1/2}, but reactions including cycle n: they are known once it has
        // moved on.
        next = state;
        release(model, steps, next);
        advance(model, forces_of(model, state, steps), step, next);
        heat_nodes(model, steps, shell_conduction(model, state, state.step), next);
        // The thickness of the next contact is that of the end of this cycle.
        if (options.thickness != nullptr) options.thickness->at(state.time, next.thickness);
        CycleRecord record;
        record.cycle = state.cycle;
        record.time = state.time;
        record.step = state.step;
        record.next_step = step;
        record.motion = &motion;
        record.contacts = &steps;
        record.totals = &totals;
        record.methods = &contacts;
        record.displacement = &state.displacement;
        record.angular_velocity = &state.angular_velocity;
        record.acceleration = &next.acceleration;
        record.reaction = &next.reaction;
        record.reaction_moment = &next.reaction_moment;
        record.temperature = &next.temperature;
        record.last = next.time > model.engine.end_time;
        observe(record);
        check_normals(model, state, steps);
        std::swap(state, next);
    }
    if (state.cycle > 0) check_finite(model, state, {});
}

}  // namespace type21
