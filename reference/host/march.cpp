#include "reference/host/march.h"

#include <algorithm>

#include <fmt/format.h>

#include "reference/host/effect_checks.h"
#include "reference/host/energy_watch.h"
#include "reference/host/finite_check.h"
#include "reference/host/integrate.h"
#include "reference/host/saved_state.h"
#include "reference/host/shell_conduction.h"
#include "reference/host/step_watch.h"
#include "reference/host/time_step.h"
#include "reference/host/when.h"

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
        for (size_t n = 0; n < steps[i].heat.size(); ++n) {
            if (steps[i].heat[n].heat != 0) give(nodes[n], steps[i].heat[n].heat);
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

/// Says at the end of a run, however it ends, what its steps were.
class StepReport {
  public:
    StepReport(const Model& model, const HostState& state, const MarchOptions& options)
        : model_(model), state_(state), options_(options) {}
    StepReport(const StepReport&) = delete;
    StepReport& operator=(const StepReport&) = delete;
    ~StepReport() {
        if (!options_.warn) return;
        // The cycle in which a run stops has not been counted yet.
        if (const auto text = warning_of(excess_, model_, std::max(state_.cycle, excess_.last_cycle + 1)))
            options_.warn(*text);
    }

    void note(const std::vector<ContactStep>& steps, const StepLimits& limits, double step) {
        note_excess(model_, state_, steps, limits, step, excess_);
        if (excess_.long_run || !is_long_run(model_, state_, step)) return;
        excess_.long_run = true;
        if (options_.warn) options_.warn(warning_of_long_run(model_, state_, step));
    }

    /// What a checkpoint holds.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(excess_);
    }

  private:
    const Model& model_;
    const HostState& state_;
    const MarchOptions& options_;
    StepExcess excess_;
};

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
    StepReport step_report(model, state, options);
    EnergyWatch energy(model, state);
    const bool absolute = absolute_temperatures(model);
    FrictionReport friction_report(model, state, options);
    std::vector<InterfaceTotals> totals(contacts.size());

    if (options.thickness != nullptr) {
        for (const Shell& shell : model.shells)
            state.thickness.push_back(shell.thickness);
    }

    // All that one cycle leaves to the next: what is added to the march is added here, too.
    const auto remembered = [&](auto& archive) {
        archive(state, time_step, totals, step_report, energy, friction_report);
    };
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
        state.update_sensors(model);
        state.impose_temperatures(model);
        const Motion motion = state.motion(reading);
        for (size_t i = 0; i < contacts.size(); ++i)
            contacts[i]->step_into(motion, steps[i]);
        check_friction(model, state, steps);
        check_finite(model, state, steps);
        check_temperatures(model, state, absolute);
        const double step = time_step.next(state, steps);
        check_step(model, state, step);
        step_report.note(steps, time_step.limits(), step);
        friction_report.note(steps);

        const double weight = reading.impulse_weight({state.step, 0.5 * (state.step + step), state.weight_before});
        for (size_t i = 0; i < totals.size(); ++i)
            add_totals(steps[i].sums, weight, totals[i]);

        // The record of cycle n holds x_n and v_{n-1/2}, but reactions including cycle n: they are known once it has
        // moved on.
        next = state;
        note_forces(steps, next.last_force);
        release(model, steps, next);
        const CycleForces forces = forces_of(model, state, steps);
        advance(model, forces, step, next);
        heat_nodes(model, steps, shell_conduction(model, state, state.step), next);
        // The thickness of the next contact is that of the end of this cycle.
        if (options.thickness != nullptr) options.thickness->at(state.time, next.thickness);
        check_finite(model, state, next, totals);
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
        energy.add(state, next, forces, steps);
        std::swap(state, next);
    }
    if (state.cycle == 0) return;
    check_finite(model, state, std::vector<ContactStep>{});
    check_temperatures(model, state, absolute);
}

}  // namespace type21
