#include "reference/host/time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace type21 {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// c: Igap 0: max(g, 0.1 max(DEPTH, Drad, g)); else max(Gapmin, least g_s, 0.1 max(DEPTH, Drad, largest g_s)).
/// @param smallest, largest  of g_s over the nodes [length]
double reach_of(const Interface& interface, double smallest, double largest) {
    const double far = std::max({double(interface.depth), double(interface.drad), largest});
    if (interface.igap == 0) return std::max(interface.largest_gap, 0.1 * far);
    return std::max({double(interface.gapmin), smallest, 0.1 * far});
}

}  // namespace

double stable_step(double mass, double stiffness) {
    return mass > 0 && stiffness > 0 ? std::sqrt(2.0 * mass / stiffness) : infinite;
}

double damped_step(double inertia, double stiffness, double damping) {
    if (!(inertia > 0) || !(stiffness > 0)) return infinite;
    const double ratio = damping / std::sqrt(4.0 * inertia * stiffness);
    const double factor = std::sqrt(1.0 + ratio * ratio) + ratio;
    return stable_step(inertia, stiffness * factor * factor);
}

TimeStep::TimeStep(const HostScene& scene) : scene_(scene), thermal_(*scene.host) {
    const Model& model = *scene.host;
    for (const Interface& interface : model.interfaces) {
        reach_.push_back(reach_of(interface, interface.smallest_gap_raw, interface.largest_gap));
        const RigidBody& tool = model.rigid_bodies[static_cast<size_t>(interface.tool)];
        inertia_.push_back(smallest_inertia(tool.inertia));
        Vec3 farthest = Vec3::Zero();
        for (const int node : interface.main_nodes) {
            const Vec3 arm = model.nodes.position[static_cast<size_t>(node)] - tool.center;
            if (arm.squaredNorm() > farthest.squaredNorm()) farthest = arm;
        }
        farthest_.push_back(farthest);
    }
}

double TimeStep::next(const HostState& state, const std::vector<ContactStep>& contacts) {
    const EngineControl& engine = scene_.host->engine;
    limits_.nodal = engine.step_scale * nodal_limit(state, contacts);
    limits_.kinematic = kinematic_limit(state, contacts);
    const ThermalLimits thermal = thermal_(state, contacts, engine.step_scale);
    limits_.thermal = thermal.step;
    limits_.thermal_stable = thermal.stable;
    const bool first = state.cycle == 0;
    const double largest = engine.largest_step.value_or(0.0);
    const double initial = engine.first_step.value_or(0.0);
    if (largest > 0 && initial == largest) return largest;
    if (first && initial > 0) return initial;
    double step = std::min({limits_.nodal, limits_.kinematic, limits_.thermal});
    if (largest > 0) step = std::min(step, largest);
    if (engine.history_interval > 0) step = std::min(step, engine.history_interval);
    return step;
}

double TimeStep::nodal_limit(const HostState& state, const std::vector<ContactStep>& contacts) const {
    const Model& model = *scene_.host;
    std::vector<double> stiffness(state.position.size(), 0.0);
    double limit = infinite;
    for (size_t i = 0; i < contacts.size(); ++i) {
        const Interface& interface = model.interfaces[i];
        for (size_t n = 0; n < contacts[i].nodes.size(); ++n) {
            stiffness[static_cast<size_t>(interface.secondary.node[n])] += contacts[i].nodes[n].step_stiffness;
        }
        const RigidBody& tool = model.rigid_bodies[static_cast<size_t>(interface.tool)];
        const ToolLoad& load = contacts[i].tool;
        limit = std::min(limit, damped_step(tool.mass, load.step_stiffness, load.damping));
        if (interface.tool_rotates && load.step_rotation > 0) {
            limit = std::min(limit, damped_step(inertia_[i], load.step_rotation, load.rotational_damping));
        }
    }
    for (size_t n = 0; n < stiffness.size(); ++n)
        limit = std::min(limit, stable_step(model.nodal_mass[n], stiffness[n]));
    return limit;
}

double TimeStep::kinematic_limit(const HostState& state, const std::vector<ContactStep>& contacts) {
    const Model& model = *scene_.host;
    double limit = infinite;
    for (size_t i = 0; i < model.interfaces.size(); ++i) {
        const Interface& interface = model.interfaces[i];
        const BodyState& tool = state.bodies[static_cast<size_t>(interface.tool)];
        if (contacts[i].active) {
            reach_[i] =
                std::min(reach_[i], reach_of(interface, contacts[i].smallest_gap_raw, contacts[i].largest_gap_raw));
        }
        Vec3 low = Vec3::Constant(infinite);
        Vec3 high = Vec3::Constant(-infinite);
        for (const int node : interface.secondary.node) {
            low = low.cwiseMin(state.velocity[static_cast<size_t>(node)]);
            high = high.cwiseMax(state.velocity[static_cast<size_t>(node)]);
        }
        const Vec3 range = (high - tool.velocity).cwiseMax(tool.velocity - low).cwiseMax(0.0);
        const Vec3 arm = tool.rotation.toRotationMatrix() * farthest_[i];
        const double speed = range.norm() + tool.angular_velocity.cross(arm).norm();
        if (speed > 0) limit = std::min(limit, 0.9 * reach_[i] / speed);
    }
    return limit;
}

}  // namespace type21
