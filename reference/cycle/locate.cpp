// Where a node touches the tool: chapters 1 and 3 to 5 of the formulation, with the exact decision of chapter 10.
#include <algorithm>

#include "reference/cycle/contact_state.h"

namespace type21::reference {

Vec3 in_tool_frame(const Vec3& position, const ToolMotion& pose) {
    return pose.rotation.transpose() * (position - pose.position);
}

ContactReach<double> Contact::State::reach_of(int i) const {
    return {nodes[static_cast<size_t>(i)].search_gap, card().depth, proximity};
}

std::vector<int> Contact::State::competitors(const Vec3& y, const ContactReach<double>& reach_of_node,
                                             const ImpactReading& how) const {
    std::vector<int> segments = candidates.at(y);
    if (how.competes) std::erase_if(segments, [&](int s) { return !how.competes(y, surface.shape(s), reach_of_node); });
    return segments;
}

StagedImpact Contact::State::decide(const Vec3& y, const std::vector<int>& segments,
                                    const ContactReach<double>& reach_of_node, const ImpactReading& how) const {
    const ShapeOf shape_of = [this](int segment) { return surface.shape(segment); };
    return staged_impact(query_of(y, reach_of_node, how.limits, how.proximity_competes), {segments, shape_of},
                         &stage_counts);
}

LocatedImpact Contact::State::locate(int i, const Vec3& position, const ToolMotion& pose,
                                     const ImpactReading& how) const {
    const double gap = nodes[static_cast<size_t>(i)].gap;
    // Formulation 1, step 1: the tool frame.
    const Vec3 y = in_tool_frame(position, pose);

    // Formulation 4, step 1: the segments that compete; Formulation 3, step 5: how far they reach.
    const ContactReach<double> reach_of_node = how.reach(reach_of(i), gap);
    const std::vector<int> segments = competitors(y, reach_of_node, how);

    // Formulation 3, step 1 to Formulation 4, step 5: the single retained impact.
    const StagedImpact retained = decide(y, segments, reach_of_node, how);
    LocatedImpact impact;
    if (retained.kind == Kind::none) return impact;
    const auto& weights = retained.projection.weights;
    impact.decision = {retained.kind, retained.segment, retained.triangle, retained.side,
                       weights.b,     weights.c,        retained.stage};

    // Formulation 5, step 1 to step 3: contact point, contact normal and signed distance.
    const SegmentShape<double> segment = surface.shape(retained.segment);
    impact.geometry = how.geometry({segment, retained.triangle, retained.projection, y, position, pose});

    // Formulation 5, step 4: geometric penetration.
    impact.penetration = geometric_penetration(gap, impact.geometry.distance, y);
    return impact;
}

}  // namespace type21::reference
