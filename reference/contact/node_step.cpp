// One secondary node in one cycle, in the order of the formulation.
#include "reference/contact/contact_state.h"
#include "reference/contact/normal_force.h"

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
    const auto leave = [&] {
        if (!time_zero) {
            history = {};
            if (friction) friction->forget(i);
        }
        return out;
    };

    // Sections 1, 3, 4, 5: where the node is, what it touches and how deep.
    if (node.stiffness == 0) return out;
    const Vec3 y = pose.rotation.transpose() * (position - pose.position);
    const Touch touch = this->touch(i, y, position, pose);
    out.decision = touch.decision;
    if (touch.decision.kind != Kind::contact) return leave();
    out.distance = touch.geometry.distance;
    out.geometric_penetration = touch.penetration;
    out.normal = pose.rotation * touch.geometry.normal;
    out.point = pose.position + pose.rotation * touch.geometry.point;
    if (touch.penetration == 0) {
        if (time_zero && as_built(Departure::D33)) history.cycles = 1;  // being retained counts, penetration or not
        if (!time_zero || history.cycles == 0) return leave();
    } else {
        ++history.cycles;
    }

    // Section 6: the offset, and whether the stiffness acts.
    const bool first_cycle = history.cycles == 1;
    if (first_cycle && !time_zero) history.offset = touch.penetration;
    if (first_cycle && has(Effect::normals_test) && touch.penetration > node.gap + 0.99 * card().depth) {
        step.inverted.push_back({model_node, touch.decision.segment, touch.penetration});
    }
    history.offset = relaxed_offset(history.offset, inacti, touch.penetration, node.gap);
    out.offset = history.offset;
    out.penetration = effective_penetration(touch.penetration, history.offset);
    const bool acts = stiffness_acts(out.penetration, history.cycles, inacti, time_zero);
    out.stiffness = acts ? node.stiffness : 0.0;
    if (release && release->now(i, out.penetration)) step.released.push_back(model_node);

    // Section 7: the normal force.
    const Vec3 arm = out.point - pose.position;
    const Vec3 velocity =
        motion.velocity[static_cast<size_t>(model_node)] - (pose.velocity + pose.angular_velocity.cross(arm));
    const double normal_velocity = velocity.dot(out.normal);
    out.elastic_force = elastic_force(out.stiffness, out.penetration);
    if (has(Effect::damping)) out.damping = damping_coefficient(card().viss, out.stiffness, node.mass);
    out.normal_force = out.elastic_force - out.damping * normal_velocity;
    out.step_stiffness = step_stiffness(out.stiffness, out.damping, motion.step);
    out.relative_velocity = velocity;

    // Section 8: friction.
    if (friction) {
        FrictionInput input;
        input.normal_force = out.normal_force;
        input.stiffness = acts ? node.friction_stiffness : 0.0;
        input.step = motion.friction_step;
        input.part_main = part_of_segment(touch.decision.segment);
        input.velocity = velocity;
        input.normal = out.normal;
        const FrictionForce tangential = friction->act(i, input);
        out.friction = tangential.force;
        out.status = tangential.slips ? Status::slip : Status::stick;
    } else if (acts) {
        out.status = Status::slip;
    }
    out.force = out.normal_force * out.normal - out.friction;
    return out;
}

}  // namespace type21::reference
