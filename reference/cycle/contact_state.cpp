#include "reference/cycle/contact_state.h"

#include <algorithm>
#include <vector>

#include "reference/contact/reach_box.h"
#include "reference/contact/stiffness.h"

namespace type21::reference {

namespace {

std::vector<NodeConstants> node_constants(const ContactModel& model, const Interface& card) {
    const SecondarySide& side = card.secondary;
    std::vector<NodeConstants> nodes(static_cast<size_t>(side.size()));
    for (size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].gap = side.gap[i];
        nodes[i].search_gap = side.search_gap[i];
        nodes[i].stiffness = nodal_stiffness(card, side.element_stiffness[i], model.as_built);
        nodes[i].friction_stiffness =
            friction_stiffness(card, nodes[i].stiffness, side.element_stiffness[i], model.as_built);
        nodes[i].mass = side.mass[i];
    }
    return nodes;
}

/// How far heat reaches beyond the gap. D11: Drad counts even when there is no radiation.
double heat_reach(const ContactModel& model, const Interface& card) {
    if (card.ithe == 0) return 0;
    double reach = 0;
    if (card.frad > 0 || model.as_built.has(Departure::D11)) reach = card.drad;
    if (card.function_distance >= 0) reach = std::max<double>(reach, card.dcond);
    return reach;
}

double farthest_reach(const Interface& card, double proximity) {
    double reach = std::max<double>(card.depth, proximity);
    for (const double gap : card.secondary.search_gap)
        reach = std::max(reach, gap);
    return reach;
}

/// The surface moved to where the tool is: as built forms the contact geometry in global axes.
SubTriangle<double> in_global_axes(SegmentShape<double> shape, int k, const ToolMotion& pose) {
    for (Vec3& node : shape.node)
        node = pose.position + pose.rotation * node;
    for (Vec3& normal : shape.normal)
        normal = pose.rotation * normal;
    return sub_triangle(shape, k);
}

Decision decision_of(const StagedImpact& impact) {
    const auto& weights = impact.projection.weights;
    return {impact.kind, impact.segment, impact.triangle, impact.side, weights.b, weights.c, impact.stage};
}

}  // namespace

Contact::State::State(const Scene& scene_, int interface_)
    : scene(scene_),
      model(scene_.model),
      interface(interface_),
      nodes(node_constants(*model, card())),
      surface(*model, card()),
      proximity(heat_reach(*model, card())),
      reach(farthest_reach(card(), proximity)),
      candidates(surface, reach),
      box_axes(reach_box_axes(tool(), card().tool_rotates)),
      inacti(card().inacti),
      offsets(nodes.size()) {
    if (has(Effect::gap_growth)) gap_growth.emplace(*model, card());
    if (has(Effect::friction)) friction.emplace(*model, card());
    if (has(Effect::skid_line)) skid_line.emplace(card().secondary.size());
    if (has(Effect::deletion)) deletion.emplace(*model, card());
    if (has(Effect::heat)) heat_exchange.emplace(*model, card());
    if (has(Effect::release_bcs)) release.emplace(card().secondary.size());
    if (has(Effect::adaptive_data)) adaptive.emplace(*model, card(), surface);
}

void Contact::State::update_gaps(const Motion& motion, ContactStep& step) {
    step.smallest_gap_raw = card().smallest_gap_raw;
    step.largest_gap_raw = card().largest_gap;
    if (!gap_growth) return;
    step.smallest_gap_raw = 1e30;
    step.largest_gap_raw = 0;
    double largest = 0;
    for (size_t i = 0; i < nodes.size(); ++i) {
        const NodalGap gap = gap_growth->gap(static_cast<int>(i), motion.thickness);
        nodes[i].gap = nodes[i].search_gap = gap.clipped;
        // D33: the largest gap of time 0 is the least that decides contact.
        if (as_built(Departure::D33))
            nodes[i].search_gap = std::max(std::min<double>(gap.raw, card().gapmax), card().largest_gap);
        largest = std::max(largest, nodes[i].search_gap);
        step.smallest_gap_raw = std::min(step.smallest_gap_raw, gap.raw);
        step.largest_gap_raw = std::max(step.largest_gap_raw, gap.raw);
    }
    if (largest <= reach) return;
    reach = 1.5 * largest;  // with room, so that a growing sheet does not rebuild them every cycle
    candidates = Candidates(surface, reach);
}

StagedImpact Contact::State::decide(const Vec3& y, const std::vector<int>& near, const ContactReach<double>& seen,
                                    const ProjectionLimits<double>& limits) const {
    const ShapeOf shape_of = [this](int segment) { return surface.shape(segment); };
    return staged_impact({y, near, shape_of, seen, limits, as_built(Departure::D11)}, &stage_counts);
}

LocatedImpact Contact::State::touch(int i, const Vec3& y, const Vec3& position, const ToolMotion& pose) const {
    const NodeConstants& node = nodes[static_cast<size_t>(i)];
    std::vector<int> near = candidates.at(y);
    if (as_built(Departure::D34)) {
        std::erase_if(near, [&](int s) {
            return !in_reach_box(y, surface.shape(s), box_axes, std::max(node.search_gap, proximity), card().depth);
        });
    }
    ProjectionLimits<double> limits;
    limits.lift_leaning = as_built(Departure::D35);
    const StagedImpact impact = decide(y, near, {node.search_gap, card().depth, proximity}, limits);
    LocatedImpact touch;
    if (impact.kind == Kind::none) return touch;
    const auto& weights = impact.projection.weights;
    touch.decision = decision_of(impact);
    if (as_built(Departure::D12)) {
        touch.geometry = contact_geometry_as_built(
            position, in_global_axes(surface.shape(impact.segment), impact.triangle, pose), weights);
        touch.geometry.normal = pose.rotation.transpose() * touch.geometry.normal;
        touch.geometry.point = pose.rotation.transpose() * (touch.geometry.point - pose.position);
    } else {
        touch.geometry =
            contact_geometry(sub_triangle(surface.shape(impact.segment), impact.triangle), impact.projection);
    }
    touch.penetration = geometric_penetration(node.gap, touch.geometry.distance, y);
    return touch;
}

LocatedImpact Contact::State::first_touch(int i, const Vec3& y, const Vec3& position, const ToolMotion& pose) const {
    if (!as_built(Departure::D31)) return touch(i, y, position, pose);
    const NodeConstants& node = nodes[static_cast<size_t>(i)];
    ProjectionLimits<double> limits{-0.05, 1.05, as_built(Departure::D35)};
    const StagedImpact impact = decide(y, candidates.at(y), {node.gap, card().depth, 0.0}, limits);
    LocatedImpact touch;
    if (impact.kind == Kind::none) return touch;
    const auto& weights = impact.projection.weights;
    touch.decision = decision_of(impact);
    const auto triangle = sub_triangle(surface.shape(impact.segment), impact.triangle);
    const double a = 1.0 - weights.b - weights.c;
    touch.geometry.point = triangle.b * weights.b + triangle.c * weights.c + triangle.a * a;
    touch.geometry.normal =
        (triangle.normal_b * weights.b + triangle.normal_c * weights.c + triangle.normal_a * a).normalized();
    touch.geometry.distance = (y - touch.geometry.point).dot(touch.geometry.normal);
    touch.penetration = geometric_penetration(node.gap, touch.geometry.distance, y);
    return touch;
}

int Contact::State::part_of_segment(int segment) const {
    const Segment& main =
        model->surfaces[static_cast<size_t>(card().main_surface)].segments[static_cast<size_t>(segment)];
    return main.shell < 0 ? -1 : model->shells[static_cast<size_t>(main.shell)].part;
}

void Contact::State::start(const Motion& motion) {
    started = true;
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card().tool)];
    if (motion.time > 0 || (inacti != 1 && inacti != 5 && inacti != 6)) return;
    bool any = false;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
        const auto n = static_cast<size_t>(i);
        const Vec3& position = motion.position[static_cast<size_t>(card().secondary.node[n])];
        const Vec3 y = pose.rotation.transpose() * (position - pose.position);
        const double penetration = first_touch(i, y, position, pose).penetration;
        if (penetration <= 0) continue;
        any = true;
        offsets[n].offset = initial_offset(inacti, penetration, nodes[n].gap, card().depth);
        if (inacti == 1) nodes[n].stiffness = nodes[n].friction_stiffness = 0;
    }
    if (!any && as_built(Departure::D26)) inacti = 0;
}

}  // namespace type21::reference
