#include "reference/host/integrate.h"

#include <cmath>

namespace type21 {

namespace {

double sensor_start(const HostState& state, int sensor) {
    return sensor < 0 ? 0.0 : state.sensors[static_cast<size_t>(sensor)].since;
}

bool sensor_on(const HostState& state, int sensor) {
    return sensor < 0 || state.sensors[static_cast<size_t>(sensor)].on;
}

/// A unit vector of an axis of a skew, or of the global axes.
Vec3 axis_of(const Model& model, int skew, int axis) {
    return skew < 0 ? Vec3(Vec3::Unit(axis)) : Vec3(model.skews[static_cast<size_t>(skew)].axes.col(axis));
}

/// What has moved so far, what moves it, and how far it has come: translations or rotations.
struct Moving {
    Vec3 before;     ///< v_{n-1/2}
    Vec3 free;       ///< acceleration that the forces give
    Vec3 travelled;  ///< since the start, for /IMPDISP
};

/// Velocity after the step.
struct Drive {
    const Model& model;
    const HostState& state;
    double step;
    double weight;

    /// @param kind  0: translations, 1: rotations
    Vec3 operator()(const NodeConditions& conditions, int kind, const Moving& moving) const {
        const int skew = conditions.skew[static_cast<size_t>(kind)];
        if (skew < 0) return along_axes(conditions, kind, moving);
        const Mat3& axes = model.skews[static_cast<size_t>(skew)].axes;
        const Mat3 to_local = axes.transpose();
        return axes * along_axes(conditions, kind,
                                 {to_local * moving.before, to_local * moving.free, to_local * moving.travelled});
    }

  private:
    Vec3 along_axes(const NodeConditions& conditions, int kind, const Moving& moving) const {
        Vec3 velocity;
        for (int d = 0; d < 3; ++d)
            velocity[d] = one(conditions, 3 * kind + d, moving.before[d], moving.free[d], moving.travelled[d]);
        return velocity;
    }

    double one(const NodeConditions& conditions, int direction, double before, double free, double travelled) const {
        const auto d = static_cast<size_t>(direction);
        if (conditions.imposed[d] >= 0) {
            using Kind = ImposedMotion::Kind;
            const ImposedMotion& motion = model.imposed_motions[static_cast<size_t>(conditions.imposed[d])];
            // An acceleration is that of t_n, like a force.
            const double ahead = motion.kind == Kind::velocity ? 0.5 : (motion.kind == Kind::displacement ? 1.0 : 0.0);
            const ImposedValue imposed = imposed_value(model, motion, state, state.time + ahead * step);
            if (imposed.acts) {
                if (motion.kind == Kind::velocity) return imposed.value;
                if (motion.kind == Kind::acceleration) return before + imposed.value * weight;
                return (imposed.value - travelled) / step;
            }
        }
        if (conditions.fixed[d]) return 0.0;
        return before + free * weight;
    }
};

/// Angular acceleration of the free body: I alpha = M - omega x I omega, all at t_n in global axes.
Vec3 angular_acceleration(const RigidBody& tool, const BodyState& state, const Vec3& moment) {
    if (!(tool.inertia.determinant() > 0)) return Vec3::Zero();
    const Mat3 rotation = state.rotation.toRotationMatrix();
    const Mat3 inertia = rotation * tool.inertia * rotation.transpose();
    const Vec3 gyroscopic =
        tool.spherical ? Vec3(Vec3::Zero()) : Vec3(state.angular_velocity.cross(inertia * state.angular_velocity));
    return inertia.ldlt().solve(moment - gyroscopic);
}

/// The force that a reaction holds against, where the manual page is silent as measured (case tool_drop): the contact,
/// and the load in the first cycle only, so that from the second cycle on REAC of a loaded node contains its load.
Vec3 held_against(const Vec3& contact, const Vec3& load, const HostState& state) {
    return state.cycle == 0 ? Vec3(contact + load) : contact;
}

void advance_body(const Model& model, const CycleForces& forces, size_t b, const Drive& drive, HostState& state) {
    const RigidBody& tool = model.rigid_bodies[b];
    BodyState& body = state.bodies[b];
    const auto main = static_cast<size_t>(tool.main_node);
    const NodeConditions& conditions = state.conditions[main];
    const Vec3 force = forces.tool_force[b] + forces.load_force[b];
    const Vec3 free = tool.mass > 0 ? Vec3(force / tool.mass) : Vec3(Vec3::Zero());
    const Vec3 free_angular = angular_acceleration(tool, body, forces.tool_moment[b] + forces.load_moment[b]);
    const Vec3 velocity = drive(conditions, 0, {body.velocity, free, body.position - tool.center});
    const Vec3 angular_velocity = drive(conditions, 1, {body.angular_velocity, free_angular, body.imposed_angle});
    const Vec3 gained = velocity - body.velocity;
    state.acceleration[main] = drive.weight > 0 ? Vec3(gained / drive.weight) : Vec3(Vec3::Zero());
    state.reaction[main] +=
        tool.mass * gained - held_against(forces.tool_force[b], forces.load_force[b], state) * drive.weight;
    const Mat3 rotation = body.rotation.toRotationMatrix();
    const Mat3 inertia = rotation * tool.inertia * rotation.transpose();
    state.reaction_moment[main] += inertia * (angular_velocity - body.angular_velocity) -
                                   held_against(forces.tool_moment[b], forces.load_moment[b], state) * drive.weight;
    body.velocity = velocity;
    body.angular_velocity = angular_velocity;
    body.position += velocity * drive.step;
    body.rotation_before = body.rotation;
    body.rotation = turned(body.rotation, angular_velocity, drive.step);
    body.imposed_angle += angular_velocity * drive.step;
}

void advance_free_node(const Model& model, const CycleForces& forces, size_t n, const Drive& drive, HostState& state) {
    const double mass = model.nodal_mass[n];
    const Vec3 force = forces.contact[n] + forces.load[n];
    const Vec3 free = mass > 0 ? Vec3(force / mass) : Vec3(Vec3::Zero());
    const Vec3 velocity = drive(state.conditions[n], 0, {state.velocity[n], free, state.position[n] - state.start[n]});
    const Vec3 gained = velocity - state.velocity[n];
    state.acceleration[n] = drive.weight > 0 ? Vec3(gained / drive.weight) : Vec3(Vec3::Zero());
    state.reaction[n] += mass * gained - held_against(forces.contact[n], forces.load[n], state) * drive.weight;
    state.velocity[n] = velocity;
    state.position[n] += velocity * drive.step;
}

}  // namespace

ImposedValue imposed_value(const Model& model, const ImposedMotion& motion, const HostState& state, double at) {
    if (state.time < motion.start || state.time > motion.stop || !sensor_on(state, motion.sensor)) return {};
    const double time = at - sensor_start(state, motion.sensor);
    return {true, motion.scale_y * model.functions[static_cast<size_t>(motion.function)](time / motion.scale_x)};
}

CycleForces no_forces(const Model& model) {
    CycleForces forces;
    forces.contact.assign(static_cast<size_t>(model.nodes.size()), Vec3::Zero());
    forces.load = forces.contact;
    forces.tool_force.assign(model.rigid_bodies.size(), Vec3::Zero());
    forces.tool_moment = forces.load_force = forces.load_moment = forces.tool_force;
    return forces;
}

namespace {

void add_forces(const Model& model, const HostState& state, CycleForces& forces) {
    for (const ConcentratedLoad& load : model.loads) {
        if (!sensor_on(state, load.sensor)) continue;
        const double time = state.time - sensor_start(state, load.sensor);
        const double value = load.scale_y * model.functions[static_cast<size_t>(load.function)](time / load.scale_x);
        const Vec3 vector = value * axis_of(model, load.skew, load.direction % 3);
        for (const int node : model.groups[static_cast<size_t>(load.group)].nodes) {
            const int body = state.body[static_cast<size_t>(node)];
            if (body < 0) {
                if (load.direction < 3) forces.load[static_cast<size_t>(node)] += vector;
                continue;
            }
            const auto b = static_cast<size_t>(body);
            if (load.direction >= 3) {
                forces.load_moment[b] += vector;
                continue;
            }
            forces.load_force[b] += vector;
            forces.load_moment[b] +=
                (state.position[static_cast<size_t>(node)] - state.bodies[b].position).cross(vector);
        }
    }
}

/// A body falls as a whole, where its main node is in the group.
void add_gravities(const Model& model, const HostState& state, CycleForces& forces) {
    for (const Gravity& gravity : model.gravities) {
        if (!sensor_on(state, gravity.sensor)) continue;
        const double time = state.time - sensor_start(state, gravity.sensor);
        const double value =
            gravity.function < 0
                ? gravity.scale_y
                : gravity.scale_y * model.functions[static_cast<size_t>(gravity.function)](time / gravity.scale_x);
        const Vec3 acceleration = value * axis_of(model, gravity.skew, gravity.direction);
        const auto pull = [&](int node) {
            const int body = state.body[static_cast<size_t>(node)];
            if (body < 0) {
                forces.load[static_cast<size_t>(node)] += model.nodal_mass[static_cast<size_t>(node)] * acceleration;
                return;
            }
            const RigidBody& tool = model.rigid_bodies[static_cast<size_t>(body)];
            if (node == tool.main_node) forces.load_force[static_cast<size_t>(body)] += tool.mass * acceleration;
        };
        if (gravity.group < 0) {
            for (int node = 0; node < model.nodes.size(); ++node)
                pull(node);
        } else {
            for (const int node : model.groups[static_cast<size_t>(gravity.group)].nodes)
                pull(node);
        }
    }
}

}  // namespace

void add_loads(const Model& model, const HostState& state, CycleForces& forces) {
    add_forces(model, state, forces);
    add_gravities(model, state, forces);
}

void advance(const Model& model, const CycleForces& forces, double step, HostState& state) {
    const Drive drive{model, state, step, 0.5 * (state.step + step)};
    for (size_t b = 0; b < state.bodies.size(); ++b)
        advance_body(model, forces, b, drive, state);
    const std::vector<Vec3> before = state.velocity;
    for (size_t n = 0; n < state.position.size(); ++n) {
        if (state.body[n] < 0) advance_free_node(model, forces, n, drive, state);
    }
    state.carry_body_nodes(model);
    for (size_t b = 0; b < state.bodies.size(); ++b) {
        for (const int node : model.rigid_bodies[b].nodes) {
            // A node of a body is held by the body: its own mass is its reaction.
            const auto n = static_cast<size_t>(node);
            const Vec3 gained = state.velocity[n] - before[n];
            state.acceleration[n] = drive.weight > 0 ? Vec3(gained / drive.weight) : Vec3(Vec3::Zero());
            state.reaction[n] += model.nodal_mass[n] * gained - (forces.contact[n]) * drive.weight;
        }
    }
    for (size_t n = 0; n < state.position.size(); ++n)
        state.displacement[n] = state.position[n] - state.start[n];
    state.time += step;
    state.weight_before = drive.weight;
    state.step = step;
    ++state.cycle;
}

}  // namespace type21
