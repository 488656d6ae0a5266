#include "reference/cycle/contact.h"

#include "reference/contact/activity.h"
#include "reference/contact/exact_sum.h"
#include "reference/contact/tool_damping.h"
#include "reference/contract/make_contact.h"
#include "reference/cycle/contact_state.h"

namespace type21::reference {

namespace {

/// Columns of the time history, before they are weighed with time (formulation section 11).
ContactSums sums_of(const std::vector<NodeContact>& nodes, double step) {
    ExactVectorSum normal, tangential, abs_normal, abs_total;
    ExactSum signed_normal, norm_total, friction_work, damping_work;
    for (const NodeContact& node : nodes) {
        if (node.status == Status::open) continue;
        const Vec3 on_tool = -node.normal_force * node.normal;
        const Vec3 total = on_tool + node.friction;
        const double normal_velocity = node.relative_velocity.dot(node.normal);
        normal.add(on_tool);
        tangential.add(node.friction);
        abs_normal.add(on_tool.cwiseAbs());
        abs_total.add(total.cwiseAbs());
        signed_normal.add(-node.normal_force);
        norm_total.add(total.norm());
        friction_work.add(step * node.relative_velocity.dot(node.friction));
        damping_work.add(node.damping * normal_velocity * normal_velocity * step);
    }
    ContactSums sums;
    sums.normal = normal.value();
    sums.tangential = tangential.value();
    sums.abs_normal = abs_normal.value();
    sums.abs_total = abs_total.value();
    sums.signed_normal = signed_normal.value();
    sums.norm_total = norm_total.value();
    sums.friction_work = friction_work.value();
    sums.damping_work = damping_work.value();
    return sums;
}

double energy_of(const std::vector<NodeContact>& nodes) {
    ExactSum energy;
    for (const NodeContact& node : nodes)
        energy.add(node.elastic_energy);
    return energy.value();
}

void add_heat(const ContactStep& step, ContactSums& sums) {
    ExactSum friction_heat, to_blank, to_tool;
    for (const NodeContact& node : step.nodes) {
        friction_heat.add(node.friction_heat);
        to_blank.add(node.heat);
    }
    for (const ToolHeat& heat : step.tool_heat)
        to_tool.add(heat.heat);
    sums.friction_heat = friction_heat.value();
    sums.heat_to_blank = to_blank.value();
    sums.heat_to_tool = to_tool.value();
}

/// Resultants of the contact about x_G, and what tool damping and time step need of it.
struct Resultants {
    Vec3 force, moment;
    double stiffness, rotation, step_stiffness, step_rotation;
};

Resultants resultants_of(const std::vector<NodeContact>& nodes, const Vec3& center) {
    ExactVectorSum force, moment;
    ExactSum stiffness, rotation, step_stiffness, step_rotation;
    for (const NodeContact& node : nodes) {
        if (node.status == Status::open) continue;
        const Vec3 arm = node.point - center;
        force.add(-node.force);
        moment.add(arm.cross(-node.force));
        stiffness.add(node.stiffness);
        rotation.add(node.stiffness * arm.squaredNorm());
        step_stiffness.add(node.step_stiffness);
        step_rotation.add(node.step_stiffness * arm.squaredNorm());
    }
    return {force.value(),    moment.value(),         stiffness.value(),
            rotation.value(), step_stiffness.value(), step_rotation.value()};
}

}  // namespace

Contact::Contact(const Scene& scene, int interface) : state_(std::make_unique<State>(scene, interface)) {}

Contact::~Contact() = default;

ContactStep Contact::step(const Motion& motion) {
    State& state = *state_;
    const Interface& card = state.card();
    ContactStep step;
    // Inacti looks at time 0, whenever the interface becomes active.
    if (!state.started) state.start(motion);
    step.active = active(*state.model, card, motion.time);
    if (!step.active) return step;
    state.update_gaps(motion, step);

    step.nodes.reserve(state.nodes.size());
    for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i)
        step.nodes.push_back(state.node_step(i, motion, step));
    step.sums = sums_of(step.nodes, motion.step);
    step.sums.elastic_energy = energy_of(step.nodes);
    if (state.heat_exchange) add_heat(step, step.sums);
    if (state.adaptive) step.adaptive = state.adaptive->elements(step.nodes, motion.position);

    const ToolMotion& pose = motion.tools[static_cast<size_t>(card.tool)];
    const Resultants resultants = resultants_of(step.nodes, pose.position);
    step.tool.force = resultants.force;
    step.tool.moment = resultants.moment;
    step.tool.step_stiffness = resultants.step_stiffness;
    step.tool.step_rotation = resultants.step_rotation;
    if (state.has(Effect::tool_damping)) {
        const bool d13 = state.as_built(Departure::D13);  // the sums hold C/dt1 as well
        ToolMotion reference;
        if (card.reference_interface >= 0) {
            const Interface& other = state.model->interfaces[static_cast<size_t>(card.reference_interface)];
            reference = motion.tools[static_cast<size_t>(other.tool)];
        }
        const RigidBody& tool = state.tool();
        step.tool.damping =
            tool_damping_coefficient(card.damp, tool.mass, d13 ? resultants.step_stiffness : resultants.stiffness);
        step.tool.damping_force = tool_damping(step.tool.damping, pose.velocity, reference.velocity);
        if (card.tool_rotates && card.dampr != 0) {
            const double inertia = smallest_inertia(tool.inertia);
            const double damping =
                tool_damping_coefficient(card.dampr, inertia, d13 ? resultants.step_rotation : resultants.rotation);
            step.tool.rotational_damping = damping;
            step.tool.damping_moment = tool_damping(damping, pose.angular_velocity, reference.angular_velocity);
        }
    }
    return step;
}

std::vector<EffectMemory> Contact::memory_by_effect() const {
    const State& state = *state_;
    std::vector<EffectMemory> rooms{{Effect::elastic, sizeof(NodeConstants) + sizeof(PenetrationHistory)}};
    if (state.gap_growth) rooms.push_back({Effect::gap_growth, GapGrowth::bytes_per_node()});
    if (state.friction) rooms.push_back({Effect::friction, Friction::bytes_per_node()});
    if (state.skid_line) rooms.push_back({Effect::skid_line, SkidLine::bytes_per_node()});
    if (state.heat_exchange) rooms.push_back({Effect::heat, HeatExchange::bytes_per_node()});
    if (state.release) rooms.push_back({Effect::release_bcs, Release::bytes_per_node()});
    if (state.deletion) rooms.push_back({Effect::deletion, Deletion::bytes_per_node()});
    return rooms;
}

DecisionStageCounts Contact::decision_stage_counts() const {
    return state_->stage_counts;
}

std::vector<InitialPenetration> Contact::initial_penetrations() const {
    return initial_penetrations(state_->model->nodes.position);
}

std::vector<InitialPenetration> Contact::initial_penetrations(const std::vector<Vec3>& positions) const {
    const State& state = *state_;
    ToolMotion pose;
    pose.position = state.tool().center;
    std::vector<InitialPenetration> found;
    for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) {
        const int node = state.card().secondary.node[static_cast<size_t>(i)];
        const Vec3& position = positions[static_cast<size_t>(node)];
        const LocatedImpact touch = state.first_touch(i, position - pose.position, position, pose);
        if (touch.penetration <= 0) continue;
        found.push_back(
            {node, touch.decision.segment, touch.penetration, touch.geometry.distance, touch.geometry.normal});
    }
    return found;
}

std::unique_ptr<ContactMethod> make_contact(const Scene& scene, int interface) {
    return std::make_unique<Contact>(scene, interface);
}

}  // namespace type21::reference
