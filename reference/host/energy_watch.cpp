#include "reference/host/energy_watch.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "reference/host/march.h"
#include "reference/host/when.h"

namespace type21 {

namespace {

bool translates(const NodeConditions& conditions) {
    return !(conditions.driven(0) && conditions.driven(1) && conditions.driven(2));
}

bool turns(const NodeConditions& conditions) {
    return !(conditions.driven(3) && conditions.driven(4) && conditions.driven(5));
}

bool turns_freely(const NodeConditions& conditions) {
    return !(conditions.driven(3) || conditions.driven(4) || conditions.driven(5));
}

/// Tools that can move, and nodes of the blank that can or that IBC may release.
bool something_is_free(const Model& model, const HostState& state) {
    for (const Interface& interface : model.interfaces) {
        const RigidBody& tool = model.rigid_bodies[static_cast<size_t>(interface.tool)];
        const NodeConditions& main = state.conditions[static_cast<size_t>(tool.main_node)];
        if (translates(main) || turns(main)) return true;
        const auto& nodes = interface.secondary.node;
        const bool any = std::any_of(nodes.begin(), nodes.end(), [&](int node) {
            const auto n = static_cast<size_t>(node);
            return state.body[n] < 0 && (interface.ibc != 0 || translates(state.conditions[n]));
        });
        if (any) return true;
    }
    return false;
}

Mat3 turned_inertia(const RigidBody& tool, const BodyState& body) {
    const Mat3 rotation = body.rotation.toRotationMatrix();
    return rotation * tool.inertia * rotation.transpose();
}

double turning_energy(const RigidBody& tool, const BodyState& body) {
    return 0.5 * body.angular_velocity.dot(turned_inertia(tool, body) * body.angular_velocity);
}

}  // namespace

EnergyWatch::EnergyWatch(const Model& model, const HostState& start)
    : model_(model), watches_(something_is_free(model, start)), limit_(default_energy_limit) {
    if (!watches_) return;
    if (model.engine.energy_limit) limit_ = *model.engine.energy_limit;
    account_.kinetic = kinetic(start);
    account_.put_in = account_.most_put_in = account_.kinetic;
    for (const Interface& interface : model.interfaces)
        touched_.emplace_back(interface.secondary.node.size());
    was_active_.assign(model.interfaces.size(), 0);
}

double EnergyWatch::kinetic(const HostState& state) const {
    double sum = 0;
    for (size_t n = 0; n < state.velocity.size(); ++n) {
        if (state.body[n] < 0) sum += 0.5 * model_.nodal_mass[n] * state.velocity[n].squaredNorm();
    }
    for (size_t b = 0; b < state.bodies.size(); ++b) {
        const RigidBody& tool = model_.rigid_bodies[b];
        sum += 0.5 * tool.mass * state.bodies[b].velocity.squaredNorm() + turning_energy(tool, state.bodies[b]);
    }
    return sum;
}

/// What loads and drives do: the change of momentum that the contact does not explain, along the mean velocity. This is
/// exact for leapfrog: m (v+^2 - v-^2) / 2 = m (v+ - v-) (v+ + v-) / 2.
double EnergyWatch::work_put_in(const HostState& state, const HostState& next, const CycleForces& forces) const {
    const double weight = next.weight_before;
    double work = 0;
    for (size_t n = 0; n < state.velocity.size(); ++n) {
        const Vec3 mean = 0.5 * (state.velocity[n] + next.velocity[n]);
        // A node of a body is carried, so its contact force meets the body's drive.
        Vec3 impulse = -forces.contact[n] * weight;
        if (state.body[n] < 0) impulse += model_.nodal_mass[n] * (next.velocity[n] - state.velocity[n]);
        work += mean.dot(impulse);
    }
    for (size_t b = 0; b < state.bodies.size(); ++b) {
        const RigidBody& tool = model_.rigid_bodies[b];
        const BodyState& before = state.bodies[b];
        const BodyState& after = next.bodies[b];
        const Vec3 mean = 0.5 * (before.velocity + after.velocity);
        work += mean.dot(tool.mass * (after.velocity - before.velocity) - forces.tool_force[b] * weight);
        const Vec3 turning = 0.5 * (before.angular_velocity + after.angular_velocity);
        if (turns_freely(state.conditions[static_cast<size_t>(tool.main_node)])) {
            work += turning.dot(forces.load_moment[b] * weight);
        } else {
            // A drive turns it: what the contact has not done, the drive has.
            work += turning_energy(tool, after) - turning_energy(tool, before) -
                    turning.dot(forces.tool_moment[b] * weight);
        }
    }
    return work;
}

double EnergyWatch::dissipated(const HostState& state, const HostState& next,
                               const std::vector<ContactStep>& steps) const {
    const double weight = next.weight_before;
    double sum = 0;
    for (size_t i = 0; i < steps.size(); ++i) {
        if (!steps[i].active) continue;
        sum += steps[i].sums.friction_work + steps[i].sums.damping_work;
        const Interface& interface = model_.interfaces[i];
        const auto of = [&](int tool, double sign) {
            const BodyState& before = state.bodies[static_cast<size_t>(tool)];
            const BodyState& after = next.bodies[static_cast<size_t>(tool)];
            const Vec3 mean = 0.5 * (before.velocity + after.velocity);
            const Vec3 turning = 0.5 * (before.angular_velocity + after.angular_velocity);
            sum -= sign * weight * (mean.dot(steps[i].tool.damping_force) + turning.dot(steps[i].tool.damping_moment));
        };
        of(interface.tool, 1);
        if (interface.reference_interface >= 0)
            of(model_.interfaces[static_cast<size_t>(interface.reference_interface)].tool, -1);
    }
    return sum;
}

/// Elastic energy that no motion has made: of nodes that are in the gap when an interface starts, and of those whose
/// gap, offset or stiffness changes while they touch.
double EnergyWatch::appeared(const std::vector<ContactStep>& steps) {
    double sum = 0;
    for (size_t i = 0; i < steps.size(); ++i) {
        std::vector<TouchMemory>& memory = touched_[i];
        if (!steps[i].active) {
            std::fill(memory.begin(), memory.end(), TouchMemory{});
            was_active_[i] = 0;
            continue;
        }
        for (size_t n = 0; n < memory.size(); ++n) {
            const NodeContact& node = steps[i].nodes[n];
            const bool touches = node.elastic_energy > 0;
            if (touches && memory[n].touches) {
                const double approach = memory[n].distance - node.distance;
                sum += node.elastic_energy - memory[n].energy - 0.5 * (node.elastic_force + memory[n].force) * approach;
            } else if (touches && was_active_[i] == 0) {
                sum += node.elastic_energy;
            }
            memory[n] = {node.elastic_energy, node.elastic_force, node.distance, touches};
        }
        was_active_[i] = 1;
    }
    return sum;
}

void EnergyWatch::add(const HostState& state, const HostState& next, const CycleForces& forces,
                      const std::vector<ContactStep>& steps) {
    if (!watches_) return;
    account_.put_in += work_put_in(state, next, forces) + appeared(steps);
    account_.dissipated += dissipated(state, next, steps);
    account_.kinetic = kinetic(next);
    account_.elastic = 0;
    for (const ContactStep& step : steps)
        account_.elastic += step.sums.elastic_energy;
    account_.most_put_in = std::max(account_.most_put_in, account_.put_in);
    judge(state);
}

void EnergyWatch::judge(const HostState& state) const {
    const double made = account_.found() - account_.put_in;
    if (!(made > limit_ * account_.most_put_in)) return;
    const std::string unit = model_.units.name(dim::energy);
    throw RunStopped(
        RunStopped::Why::diverged,
        fmt::format("the energy grows without reason, {}: {:.6g} {unit} found (kinetic {:.6g}, elastic {:.6g}, "
                    "dissipated {:.6g}), {:.6g} {unit} put in; {:.6g} {unit} from nowhere are more than {:g} times the "
                    "largest energy put in ({} of /STOP); the time step is too large: leave /DTIX out, or give a "
                    "smaller step",
                    when(state, model_.units), account_.found(), account_.kinetic, account_.elastic,
                    account_.dissipated, account_.put_in, made, limit_,
                    model_.engine.energy_limit ? "the limit" : "the default limit without Emax",
                    fmt::arg("unit", unit)));
}

}  // namespace type21
