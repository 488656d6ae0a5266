// Set-up, gaps of a cycle, and the histories of time 0.
#include <algorithm>

#include <Eigen/Eigenvalues>

#include "optimized/contact_state.h"
#include "optimized/kernel/normal_law.h"
#include "optimized/search/sorted/sort_margin.h"

namespace type21::optimized {

namespace {

/// k of a node: Stfac S between Stmin and Stmax; Stfac with Istf 1.
/// @manual field Istf, Stfac, Stmin, Stmax; comment 6, 11; departure D01
double stiffness_of(const Interface& card, double s, const AsBuilt& as_built) {
    if (card.istf == 1) return card.stfac;
    const double k = card.stfac * s;
    if (as_built.has(Departure::D01)) return k;
    return k < card.stmin ? double(card.stmin) : (card.stmax < k ? double(card.stmax) : k);
}

}  // namespace

/// @manual departure D04
Contact::State::State(const Scene& scene_, int interface_, const ContactOptions& options_)
    : scene(scene_),
      interface(interface_),
      options(options_),
      laws(scene_, interface_),
      largest_reach(0),
      inacti(laws.card->inacti) {
    const Interface& card = *laws.card;
    const SecondarySide& side = card.secondary;
    const size_t n = side.node.size();
    nodes.node = side.node;
    nodes.gap = side.gap;
    if (side.search_gap != side.gap || laws.growth) nodes.search_gap = side.search_gap;
    nodes.mass = side.mass;
    nodes.stiffness.resize(n);
    for (size_t i = 0; i < n; ++i)
        nodes.stiffness[i] = stiffness_of(card, side.element_stiffness[i], laws.model->as_built);
    if (laws.as_built(Departure::D04)) {
        nodes.friction_stiffness = side.element_stiffness;
        if (card.istf == 1) std::fill(nodes.friction_stiffness.begin(), nodes.friction_stiffness.end(), 1.0);
    }
    nodes.offset.assign(n, 0.0);
    nodes.cycles.assign(n, 0);
    if (options.search == SearchKind::tree) nodes.memory.resize(n);
    if (laws.has(effect::friction)) nodes.friction.resize(n);
    if (laws.skid) nodes.skid.assign(n, 0.0);
    if (laws.release) nodes.released.assign(n, 0);
    if (has(Effect::adaptive_data)) adaptive.emplace(*laws.model, card, laws.tool);
    largest_reach = laws.proximity;
    for (size_t i = 0; i < n; ++i)
        largest_reach = std::max(largest_reach, nodes.deciding_gap(i));
    new_search();
    lists.resize((n + chunk - 1) / chunk);
    one_by_one = kernel_for(laws.effects());
    const RigidBody& tool = laws.model->rigid_bodies[static_cast<size_t>(card.tool)];
    if (has(Effect::tool_damping) && card.tool_rotates)
        least_inertia = Eigen::SelfAdjointEigenSolver<Mat3>(tool.inertia).eigenvalues().minCoeff();
}

void Contact::State::new_search() {
    const Interface& card = *laws.card;
    const AsBuilt& as_built = laws.model->as_built;
    ReachBoxRule boxes;
    boxes.on = as_built.has(Departure::D34);
    boxes.proximity = laws.proximity;
    if (boxes.on && card.tool_rotates) {
        const RigidBody& tool = laws.model->rigid_bodies[static_cast<size_t>(card.tool)];
        boxes.axes = Eigen::SelfAdjointEigenSolver<Mat3>(tool.inertia).eigenvectors();
    }
    CaptureLimits limits;
    limits.outward = largest_reach;
    limits.inward = card.depth;
    limits.margin = as_built.has(Departure::D31) ? 0.05 : 0.01;
    limits.lift_leaning = as_built.has(Departure::D35);
    laws.search = std::make_unique<Search>(laws.tool, limits, boxes, options.search);
    if (options.search == SearchKind::sorted)
        candidates = std::make_unique<CandidateLists>(laws.search->boxes(),
                                                      sort_margin(*laws.model, card, laws.proximity, options.bumult));
    // What nodes remember holds for the old limits only.
    for (Memory& memory : nodes.memory)
        memory.forget();
}

/// @manual field Igap; departure D33
void Contact::State::update_gaps(const Motion& motion, ContactStep& step) {
    const Interface& card = *laws.card;
    step.smallest_gap_raw = card.smallest_gap_raw;
    step.largest_gap_raw = card.largest_gap;
    if (!laws.growth) return;
    step.smallest_gap_raw = 1e30;
    step.largest_gap_raw = 0;
    double most = 0;
    for (size_t i = 0; i < nodes.gap.size(); ++i) {
        const GrownGap gap = laws.growth->at(static_cast<int>(i), motion.thickness);
        nodes.gap[i] = nodes.search_gap[i] = gap.clipped;
        // D33: the largest gap of time 0 is the least that decides contact.
        if (laws.d33) nodes.search_gap[i] = std::max(std::min(gap.raw, double(card.gapmax)), card.largest_gap);
        most = std::max(most, nodes.search_gap[i]);
        step.smallest_gap_raw = std::min(step.smallest_gap_raw, gap.raw);
        step.largest_gap_raw = std::max(step.largest_gap_raw, gap.raw);
    }
    if (most <= largest_reach) return;
    largest_reach = 1.25 * most;  // more than needed, so that a growing sheet does not build a new search every cycle
    new_search();
}

Contact::State::StartImpact Contact::State::impact_at_start(size_t i, std::span<const Vec3> positions,
                                                            const ToolMotion& pose, const CandidateLists* start) const {
    const Interface& card = *laws.card;
    const Vec3& position = positions[static_cast<size_t>(nodes.node[i])];
    const V3 y = in_tool_frame(i, positions, pose);
    const auto impact = [&](const ContactReach& reach, const ProjectionLimits& rules, bool reach_boxes) {
        if (start != nullptr) return laws.search->search(start->of(i), y, reach, rules, reach_boxes);
        return laws.search->search(y, reach, rules, reach_boxes);
    };
    StartImpact first;
    if (laws.as_built(Departure::D31)) {
        ProjectionLimits rules = laws.rules;
        rules.low = -0.05;
        rules.high = 1.05;
        first.retained = impact({nodes.gap[i], card.depth, 0.0}, rules, false);
        if (!first.retained.exists()) return first;
        first.point = contact_point_at_start(laws.tool, first.retained, y);
    } else {
        first.retained = impact({nodes.deciding_gap(i), card.depth, laws.proximity}, laws.rules, true);
        if (!first.retained.exists()) return first;
        first.point = laws.d12 ? contact_point_as_built(laws.tool, first.retained, y, position, pose)
                               : contact_point(laws.tool, first.retained, pose);
    }
    first.penetration = penetration_beyond_rounding(nodes.gap[i], first.point.distance, largest(y));
    return first;
}

std::vector<Contact::State::StartImpact> Contact::State::impacts_at_start(std::span<const Vec3> position,
                                                                          const ToolMotion& pose) const {
    // Nothing moves here, so the lists need no margin.
    std::optional<CandidateLists> start;
    if (options.search == SearchKind::sorted)
        start.emplace(laws.search->boxes(), 0.0).sort(in_tool_frame(position, pose));
    std::vector<StartImpact> impacts(nodes.node.size());
    for (size_t i = 0; i < impacts.size(); ++i)
        impacts[i] = impact_at_start(i, position, pose, start ? &*start : nullptr);
    return impacts;
}

/// @manual field Inacti; comment 9; departure D26
void Contact::State::start(const Motion& motion) {
    started = true;
    if (motion.time > 0 || (inacti != 1 && inacti != 5 && inacti != 6)) return;
    const ToolMotion& pose = motion.tools[static_cast<size_t>(laws.card->tool)];
    bool any = false;
    const std::vector<StartImpact> impacts = impacts_at_start(motion.position, pose);
    for (size_t i = 0; i < impacts.size(); ++i) {
        const double p = impacts[i].penetration;
        if (p <= 0) continue;
        any = true;
        nodes.offset[i] = offset_at_start(inacti, p, nodes.gap[i], laws.card->depth);
        if (inacti == 1) nodes.stiffness[i] = 0;
    }
    if (!any && laws.as_built(Departure::D26)) inacti = 0;
}

/// @manual comment 8; departure D31
std::vector<InitialPenetration> Contact::initial_penetrations(const std::vector<Vec3>& positions) const {
    const State& state = *state_;
    ToolMotion pose;
    pose.position = state.laws.model->rigid_bodies[static_cast<size_t>(state.laws.card->tool)].center;
    std::vector<InitialPenetration> found;
    const std::vector<State::StartImpact> impacts = state.impacts_at_start(positions, pose);
    for (size_t i = 0; i < impacts.size(); ++i) {
        const State::StartImpact& first = impacts[i];
        if (first.penetration <= 0) continue;
        found.push_back({state.nodes.node[i], first.retained.id.segment(), first.penetration, first.point.distance,
                         to_vec3(first.point.normal)});
    }
    return found;
}

}  // namespace type21::optimized
