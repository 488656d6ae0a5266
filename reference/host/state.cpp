#include "reference/host/state.h"

namespace type21 {

HostState::HostState(const Model& model)
    : conditions(node_conditions(model)), body(bodies_of_nodes(model)), start(model.nodes.position) {
    const auto count = static_cast<size_t>(model.nodes.size());
    for (const RigidBody& tool : model.rigid_bodies)
        start[static_cast<size_t>(tool.main_node)] = tool.center;
    position = start;
    velocity.assign(count, Vec3::Zero());
    acceleration = displacement = angular_velocity = reaction = reaction_moment = velocity;
    for (const InitialVelocity& initial : model.initial_velocities) {
        for (const int node : model.groups[static_cast<size_t>(initial.group)].nodes)
            velocity[static_cast<size_t>(node)] = initial.velocity;
    }
    for (const RigidBody& tool : model.rigid_bodies) {
        BodyState state;
        state.position = tool.center;
        state.velocity = velocity[static_cast<size_t>(tool.main_node)];
        bodies.push_back(state);
    }
    carry_body_nodes(model);
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

Motion HostState::motion(const Model& model) const {
    Motion m;
    m.time = time;
    m.step = step;
    // D25: the friction increment weighs with the half sum of steps of the cycle before.
    m.friction_step = model.as_built.has(Departure::D25) ? weight_before : step;
    m.position = position;
    m.velocity = velocity;
    for (const BodyState& state : bodies) {
        // D24: the orientation is one step older than the position.
        const Rotation& rotation = model.as_built.has(Departure::D24) ? state.rotation_before : state.rotation;
        m.tools.push_back({state.position, rotation.toRotationMatrix(), state.velocity, state.angular_velocity});
    }
    return m;
}

}  // namespace type21
