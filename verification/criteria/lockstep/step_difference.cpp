#include "verification/criteria/lockstep/step_difference.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "verification/criteria/lockstep/node_scale.h"
#include "verification/decisions/queries/decision_block.h"

namespace type21 {

namespace {

enum Quantity : int { force, friction, stiffness, heat, sum, count };
constexpr std::array<const char*, count> names{"force", "friction", "stiffness", "heat", "sums"};

bool same(const Decision& one, const Decision& other) {
    return one.kind == other.kind && one.segment == other.segment && one.triangle == other.triangle &&
           one.side == other.side;
}

std::string text(const Decision& d) {
    if (d.kind == Kind::none) return "none";
    return fmt::format("{}, segment {}, triangle {}, side {:+}", name(d.kind), d.segment + 1, d.triangle, d.side);
}

double largest(const Vec3& v) {
    return v.cwiseAbs().maxCoeff();
}

double speed_of_tools(const Motion& motion) {
    double speed = 0;
    for (const ToolMotion& tool : motion.tools)
        speed += tool.velocity.norm();
    return speed;
}

double turning_of_tools(const Motion& motion) {
    double turning = 0;
    for (const ToolMotion& tool : motion.tools)
        turning += tool.angular_velocity.norm();
    return turning;
}

}  // namespace

LockstepResult::LockstepResult() {
    for (const char* name : names)
        tally.emplace_back(name);
}

/// Sums over the nodes of the scales of their terms.
struct StepDifference::Scales {
    double force = 0, moment = 0, stiffness = 0, rotation = 0, work = 0, energy = 0, heat = 0;
    double damping = 0, damping_moment = 0;
    bool grazes = false;  ///< a stiffness acts in one of the two only
};

void StepDifference::add(const ContactStep& reference, const ContactStep& other, const Motion& motion, long cycle) {
    place_ = {cycle, motion.time, card_.id, 0};
    if (reference.active != other.active || reference.nodes.size() != other.nodes.size() ||
        reference.heat.size() != other.heat.size() || reference.skid.size() != other.skid.size()) {
        decision_differs(fmt::format("the interface is {}; the reference: {}", other.active ? "active" : "inactive",
                                     reference.active ? "active" : "inactive"));
        ++result_.different;
        return;
    }
    if (!reference.active) return;
    ++result_.cycles;
    Scales scale;
    for (size_t i = 0; i < reference.nodes.size(); ++i)
        node(i, reference, other, motion, scale);
    place_.node = 0;
    scale.work *= motion.step;
    // The velocities are given: the rounding is that of the product and, in C and in the moment, of the arms.
    scale.damping = reference.tool.damping * speed_of_tools(motion);
    scale.damping_moment = reference.tool.rotational_damping * turning_of_tools(motion) *
                           (1 + (reference.tool.step_rotation > 0 ? scale.rotation / reference.tool.step_rotation : 0));
    sums(reference, other, scale);
    lists(reference, other);
}

void StepDifference::node(size_t i, const ContactStep& reference_step, const ContactStep& other_step,
                          const Motion& motion, Scales& sum) {
    const NodeContact &reference = reference_step.nodes[i], &other = other_step.nodes[i];
    const bool heated = !reference_step.heat.empty();
    const NodeHeat flow = heated ? reference_step.heat[i] : NodeHeat{};
    const double heat_apart = heated ? std::abs(flow.heat - other_step.heat[i].heat) : 0.0;
    place_.node = model_.nodes.id[static_cast<size_t>(card_.secondary.node[i])];
    NodeScale scale = node_scale(card_, i, reference, flow, motion, model_.as_built.has(Departure::D12));
    // A direction that was noise (D12) stays in the friction for as long as the node is in contact.
    if (noise_.empty()) noise_.resize(static_cast<size_t>(card_.secondary.size()), 0.0);
    noise_[i] = reference.status == Status::open ? 0.0 : std::max(noise_[i], scale.force);
    if (model_.as_built.has(Departure::D12)) scale.force = std::max(scale.force, noise_[i]);
    ++result_.decisions;
    if (!same(reference.decision, other.decision)) {
        ++result_.different;
        decision_differs(
            fmt::format("decision: {}; the reference: {}", text(other.decision), text(reference.decision)));
    }
    sum.force += scale.force;
    sum.moment += scale.force * scale.arm;
    sum.stiffness += scale.stiffness;
    sum.rotation += scale.stiffness * scale.arm * scale.arm;
    sum.work += scale.force * scale.speed;
    // k p times the error of p; if p itself is rounding, its square.
    const double rounding = 32 * ulp_of_one * scale.length;
    sum.energy += scale.force * (reference.penetration + rounding) + std::abs(reference.elastic_energy);
    sum.heat += scale.heat;
    // The cycle in which a node begins to slide depends on the last bit if the trial force just reaches the limit.
    if (!reference_step.skid.empty() && reference.status == Status::slip && other.status == Status::slip)
        skid(i, reference_step.skid[i] - other_step.skid[i], scale.force);
    if (reference.status == Status::open && other.status == Status::open) {
        if (flow.heat != 0 || heat_apart != 0) tally(heat, heat_apart, scale.heat);
        return;
    }
    ++result_.in_contact;
    // A penetration of a few units in the last place may be zero in the other implementation, by rounding. The
    // stiffness then acts in one of the two only.
    const bool one_open = (reference.status == Status::open) != (other.status == Status::open);
    const bool one_acts = (reference.stiffness == 0) != (other.stiffness == 0);
    const double deep = std::max(reference.penetration, other.penetration);
    if ((one_open || one_acts) && deep <= rounding) {
        ++result_.grazing;
        sum.grazes = true;
        return;
    }
    tally(force, largest(reference.force - other.force), scale.force);
    tally(friction, largest(reference.friction - other.friction), scale.force);
    tally(stiffness,
          std::max(std::abs(reference.stiffness - other.stiffness),
                   std::abs(reference.step_stiffness - other.step_stiffness)),
          scale.stiffness);
    if (heated) tally(heat, heat_apart, scale.heat);
}

/// Compares a ratio of the skid line as the friction force that caused it, which may have acted long ago.
void StepDifference::skid(size_t i, double apart, double force_scale) {
    if (skid_scale_.empty()) skid_scale_.resize(static_cast<size_t>(card_.secondary.size()), 0.0);
    skid_scale_[i] = std::max(skid_scale_[i], force_scale);
    tally(friction, std::abs(apart) * card_.pskid * card_.secondary.area[i] / std::sqrt(3.0), skid_scale_[i]);
}

void StepDifference::sums(const ContactStep& reference, const ContactStep& other, const Scales& scale) {
    const ContactSums &a = reference.sums, &b = other.sums;
    const ToolLoad &p = reference.tool, &q = other.tool;
    add_sum("normal", largest(a.normal - b.normal), scale.force);
    add_sum("tangential", largest(a.tangential - b.tangential), scale.force);
    add_sum("abs_normal", largest(a.abs_normal - b.abs_normal), scale.force);
    add_sum("signed_normal", std::abs(a.signed_normal - b.signed_normal), scale.force);
    add_sum("abs_total", largest(a.abs_total - b.abs_total), scale.force);
    add_sum("norm_total", std::abs(a.norm_total - b.norm_total), scale.force);
    add_sum("elastic_energy", std::abs(a.elastic_energy - b.elastic_energy), scale.energy);
    add_sum("friction_work", std::abs(a.friction_work - b.friction_work), scale.work);
    add_sum("damping_work", std::abs(a.damping_work - b.damping_work), scale.work);
    add_sum("friction_heat", std::abs(a.friction_heat - b.friction_heat), scale.heat);
    add_sum("heat_to_blank", std::abs(a.heat_to_blank - b.heat_to_blank), scale.heat);
    add_sum("heat_to_tool", std::abs(a.heat_to_tool - b.heat_to_tool), scale.heat);
    add_sum("tool force", largest(p.force - q.force), scale.force);
    add_sum("tool moment", largest(p.moment - q.moment), scale.moment);
    if (scale.grazes) return;  // a stiffness acts in one of them only
    add_sum("tool damping", largest(p.damping_force - q.damping_force), scale.damping);
    add_sum("tool damping moment", largest(p.damping_moment - q.damping_moment), scale.damping_moment);
    add_sum("step stiffness", std::abs(p.step_stiffness - q.step_stiffness), scale.stiffness);
    add_sum("step rotation", std::abs(p.step_rotation - q.step_rotation), scale.rotation);
}

void StepDifference::lists(const ContactStep& reference, const ContactStep& other) {
    const bool same_nodes = std::equal(
        reference.inverted.begin(), reference.inverted.end(), other.inverted.begin(), other.inverted.end(),
        [](const InvertedNormal& a, const InvertedNormal& b) { return a.node == b.node && a.segment == b.segment; });
    if (same_nodes && reference.released == other.released) return;
    ++result_.lists;
    decision_differs(fmt::format("released {} and inverted {} nodes; the reference: {} and {}", other.released.size(),
                                 other.inverted.size(), reference.released.size(), reference.inverted.size()));
}

void StepDifference::add_sum(const char* which, double difference, double scale) {
    tally(sum, difference, scale, which);
}

void StepDifference::tally(int quantity, double difference, double scale, const char* which) {
    UlpTally& to = result_.tally[static_cast<size_t>(quantity)];
    to.add(difference, scale, place_);
    if (!result_.first_force && difference != 0 && !(difference <= lockstep_ulps * ulp_of_one * scale))
        result_.first_force = {place_, fmt::format("{} {}: off by {:.3g}, {:.3g} ulps of {:.3g}", to.name(), which,
                                                   difference, difference / (ulp_of_one * scale), scale)};
}

void StepDifference::decision_differs(const std::string& what) {
    if (!result_.first_decision) result_.first_decision = {place_, what};
}

}  // namespace type21
