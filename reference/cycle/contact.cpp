#include "reference/cycle/contact.h"

#include "reference/contact/activity.h"
#include "reference/contact/exact_sum.h"
#include "reference/contact/tool_damping.h"
#include "reference/contract/make_contact.h"
#include "reference/cycle/contact_state.h"

namespace type21::reference {

namespace {

/// Columns of the time history, before they are weighed with time.  Formulation 11, step 8.
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
    for (const NodeHeat& node : step.heat) {
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
    ToolStiffness contact;  ///< of k
    ToolStiffness step;     ///< of k + C/dt1
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
    return {force.value(),
            moment.value(),
            {stiffness.value(), rotation.value()},
            {step_stiffness.value(), step_rotation.value()}};
}

/// Damping of the tool's own motion, relative to the tool of IDref if there is one.  Formulation 9, step 16.
/// @param stiffness  on which the tool is damped
void damp_tool(const ContactModel& model, const Interface& card, const ContactReading& reading, const Motion& motion,
               const ToolStiffness& stiffness, ToolLoad& load) {
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card.tool)];
    const RigidBody& tool = model.rigid_bodies[static_cast<size_t>(card.tool)];
    ToolMotion reference;
    if (card.reference_interface >= 0) {
        const Interface& other = model.interfaces[static_cast<size_t>(card.reference_interface)];
        reference = motion.tools[static_cast<size_t>(other.tool)];
    }
    load.damping = tool_damping_coefficient(card.damp, tool.mass, stiffness.translation);
    load.damping_force = tool_damping(load.damping, pose.velocity, reference.velocity);
    if (!card.tool_rotates || card.dampr == 0) return;
    const Vec3 spin = pose.angular_velocity - reference.angular_velocity;
    const double inertia = reading.damped_inertia(tool, pose.rotation, spin);
    load.rotational_damping = tool_damping_coefficient(card.dampr, inertia, stiffness.rotation);
    load.damping_moment = tool_damping(load.rotational_damping, pose.angular_velocity, reference.angular_velocity);
}

}  // namespace

Contact::Contact(const Scene& scene, int interface) : state_(std::make_unique<State>(scene, interface)) {}

Contact::~Contact() = default;

ContactStep Contact::step(const Motion& motion) {
    State& state = *state_;
    ContactStep step;
    // Formulation 6, step 1: Inacti acts at time 0, whenever the interface becomes active.
    if (!state.started) state.start(motion);
    // Formulation 9, step 2: activity in time.
    step.active = active(state.card(), motion);
    if (!step.active) return step;
    // Formulation 2, step 5: gaps that follow the thickness.
    state.update_gaps(motion, step);

    // Chapters 1 to 9: each node on its own.
    step.nodes.reserve(state.nodes.size());
    if (state.heat_exchange) step.heat.resize(state.nodes.size());
    if (state.skid_line) step.skid.resize(state.nodes.size());
    for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i)
        step.nodes.push_back(state.node_step(i, motion, step));

    // Formulation 11, step 8: sums for the columns of the interface.
    step.sums = sums_of(step.nodes, motion.step);
    step.sums.elastic_energy = energy_of(step.nodes);
    if (state.heat_exchange) add_heat(step, step.sums);
    // Formulation 9, step 15: data for adaptive meshing.
    if (state.adaptive) step.adaptive = state.adaptive->elements(step.nodes, motion.position);

    // Formulation 11, step 5: what the tool gets of the contact. Formulation 9, step 16: tool damping.
    const Resultants resultants = resultants_of(step.nodes, state.pose(motion).position);
    step.tool.force = resultants.force;
    step.tool.moment = resultants.moment;
    step.tool.step_stiffness = resultants.step.translation;
    step.tool.step_rotation = resultants.step.rotation;
    if (state.has(Effect::tool_damping)) {
        const ToolStiffness stiffness = state.reading.tool_damping_stiffness(resultants.contact, resultants.step);
        damp_tool(*state.model, state.card(), state.reading, motion, stiffness, step.tool);
    }
    return step;
}

std::vector<EffectMemory> Contact::memory_by_effect() const {
    const State& state = *state_;
    std::vector<EffectMemory> memory{
        {Effect::elastic, sizeof(NodeConstants) + sizeof(PenetrationHistory), sizeof(NodeContact)}};
    if (state.gap_growth) memory.push_back({Effect::gap_growth, GapGrowth::bytes_per_node()});
    if (state.friction) memory.push_back({Effect::friction, Friction::bytes_per_node()});
    if (state.skid_line) memory.push_back({Effect::skid_line, SkidLine::bytes_per_node(), sizeof(double)});
    if (state.heat_exchange) memory.push_back({Effect::heat, HeatExchange::bytes_per_node(), sizeof(NodeHeat)});
    if (state.release) memory.push_back({Effect::release_bcs, Release::bytes_per_node()});
    if (state.deletion) memory.push_back({Effect::deletion, Deletion::bytes_per_node()});
    return memory;
}

DecisionStageCounts Contact::decision_stage_counts() const {
    return state_->stage_counts;
}

void Contact::save(StateWriter& out) const {
    State::visit(out, *state_);
}

void Contact::restore(StateReader& in) {
    State::visit(in, *state_);
    state_->restore_reach();
}

std::vector<InitialPenetration> Contact::initial_penetrations() const {
    return initial_penetrations(state_->model->nodes.position);
}

std::vector<InitialPenetration> Contact::initial_penetrations(const std::vector<Vec3>& positions) const {
    const State& state = *state_;
    ToolMotion initial_pose;
    initial_pose.position = state.tool().center;
    std::vector<InitialPenetration> found;
    for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) {
        const size_t node = state.model_node(i);
        const LocatedImpact impact = state.locate(i, positions[node], initial_pose, state.reading.first_impact);
        if (impact.penetration <= 0) continue;
        found.push_back({static_cast<int>(node), impact.decision.segment, impact.penetration, impact.geometry.distance,
                         impact.geometry.normal});
    }
    return found;
}

std::unique_ptr<ContactMethod> make_contact(const Scene& scene, int interface) {
    return std::make_unique<Contact>(scene, interface);
}

}  // namespace type21::reference
