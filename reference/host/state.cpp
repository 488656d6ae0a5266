#include "reference/host/state.h"

namespace type21 {

namespace {

/// T0 of the material of each node's shells, then /INITEMP. Nothing in a model without heat.
std::vector<double> initial_temperatures(const Model& model) {
    if (model.nodal_heat_capacity.empty() && model.initial_temperatures.empty() && model.imposed_temperatures.empty())
        return {};
    std::vector<double> temperature(static_cast<size_t>(model.nodes.size()), 0.0);
    for (const Shell& shell : model.shells) {
        const Material& material =
            model.materials[static_cast<size_t>(model.parts[static_cast<size_t>(shell.part)].material)];
        if (!material.heat) continue;
        for (const int node : shell.node)
            temperature[static_cast<size_t>(node)] = material.heat->initial_temperature;
    }
    for (const InitialTemperature& initial : model.initial_temperatures) {
        for (const int node : model.groups[static_cast<size_t>(initial.group)].nodes) {
            temperature[static_cast<size_t>(node)] = initial.temperature;
        }
    }
    return temperature;
}

/// The angular velocity counts for the main node of a rigid body only: single nodes do not turn.
void give_velocity(const Model& model, const InitialVelocity& initial, HostState& state) {
    for (const int node : model.groups[static_cast<size_t>(initial.group)].nodes) {
        const auto n = static_cast<size_t>(node);
        switch (initial.kind) {
            case InitialVelocity::Kind::translation:
                state.velocity[n] = initial.velocity;
                break;
            case InitialVelocity::Kind::rotation:
                state.angular_velocity[n] = initial.angular_velocity;
                break;
            case InitialVelocity::Kind::axis:
                state.velocity[n] = initial.velocity + initial.angular_velocity.cross(state.start[n] - initial.origin);
                state.angular_velocity[n] = initial.angular_velocity;
                break;
        }
    }
}

}  // namespace

HostState::HostState(const Model& model)
    : conditions(node_conditions(model)), body(bodies_of_nodes(model)), start(model.nodes.position) {
    const auto count = static_cast<size_t>(model.nodes.size());
    for (const RigidBody& tool : model.rigid_bodies)
        start[static_cast<size_t>(tool.main_node)] = tool.center;
    position = start;
    velocity.assign(count, Vec3::Zero());
    acceleration = displacement = angular_velocity = reaction = reaction_moment = velocity;
    for (const InitialVelocity& initial : model.initial_velocities)
        give_velocity(model, initial, *this);
    for (const RigidBody& tool : model.rigid_bodies) {
        BodyState state;
        state.position = tool.center;
        state.velocity = velocity[static_cast<size_t>(tool.main_node)];
        state.angular_velocity = angular_velocity[static_cast<size_t>(tool.main_node)];
        bodies.push_back(state);
    }
    for (size_t n = 0; n < count; ++n) {
        if (body[n] < 0) angular_velocity[n].setZero();
    }
    carry_body_nodes(model);
    temperature = initial_temperatures(model);
    sensors.resize(model.sensors.size());
    last_force.resize(model.interfaces.size());
}

void HostState::update_sensors(const Model& model) {
    type21::update_sensors(model, time, position, last_force, sensors);
}

void HostState::impose_temperatures(const Model& model) {
    if (temperature.empty()) return;
    for (const ImposedTemperature& imposed : model.imposed_temperatures) {
        double begin = 0;
        if (imposed.sensor >= 0) {
            const SensorState& sensor = sensors[static_cast<size_t>(imposed.sensor)];
            if (!sensor.on) continue;
            begin = sensor.since;
        }
        if (time < imposed.start || time > imposed.stop) continue;
        const double value =
            imposed.scale_y * model.functions[static_cast<size_t>(imposed.function)]((time - begin) / imposed.scale_x);
        for (const int node : model.groups[static_cast<size_t>(imposed.group)].nodes)
            temperature[static_cast<size_t>(node)] = value;
    }
}

void HostState::carry_body_nodes(const Model& model) {
    for (size_t b = 0; b < bodies.size(); ++b) {
        const RigidBody& tool = model.rigid_bodies[b];
        const BodyState& state = bodies[b];
        const Mat3 rotation = state.rotation.toRotationMatrix();
        const auto carry = [&](int node) {
            const auto n = static_cast<size_t>(node);
            const Vec3 arm = rotation * (start[n] - tool.center);
            position[n] = state.position + arm;
            velocity[n] = state.velocity + state.angular_velocity.cross(arm);
            angular_velocity[n] = state.angular_velocity;
        };
        for (const int node : tool.nodes)
            carry(node);
        carry(tool.main_node);
    }
}

Motion HostState::motion(const HostReading& reading) const {
    Motion m;
    m.time = time;
    m.step = step;
    m.friction_step = reading.friction_step({step, 0.0, weight_before});
    m.position = position;
    m.velocity = velocity;
    m.thickness = thickness;
    m.temperature = temperature;
    for (const BodyState& state : bodies) {
        const Rotation& rotation = reading.tool_rotation(state.rotation, state.rotation_before);
        m.tools.push_back({state.position, rotation.toRotationMatrix(), state.velocity, state.angular_velocity});
    }
    m.sensor_on.reserve(sensors.size());
    for (const SensorState& sensor : sensors)
        m.sensor_on.push_back(sensor.on);
    return m;
}

}  // namespace type21
