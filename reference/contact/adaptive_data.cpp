#include "reference/contact/adaptive_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace type21::reference {

namespace {

/// Radius along the mid-line from one pair of corners to the other.
double mid_line_radius(const Vec3& line, const Vec3& normal_change) {
    constexpr double flat = 1e-20;
    const double length = line.norm();
    if (length == 0) return 1.0 / flat;  // the collapsed mid-line of a triangle's tip
    return length / std::max(flat, std::abs(normal_change.dot(line) / length));
}

}  // namespace

SegmentCurvature segment_curvature(const SegmentShape<double>& s) {
    const auto& x = s.node;
    const auto& n = s.normal;
    SegmentCurvature curvature;
    curvature.radius = std::min(mid_line_radius((x[1] + x[2]) - (x[0] + x[3]), (n[1] + n[2]) - (n[0] + n[3])),
                                mid_line_radius((x[3] + x[2]) - (x[0] + x[1]), (n[3] + n[2]) - (n[0] + n[1])));
    const Vec3 facet = (x[2] - x[0]).cross(x[3] - x[1]).normalized();
    for (size_t j = 0; j < 4; ++j)
        curvature.cosine = std::min(curvature.cosine, facet.dot(n[j]));
    return curvature;
}

bool divides(const Interface& interface, const AdaptiveElement& element, double radius_factor) {
    const double smallest =
        radius_factor * (interface.iadm == 2 ? double(interface.nradm) : 1.0) * element.longest_edge;
    if (element.radius < smallest) return true;
    if (interface.iadm != 2) return false;
    const double limit = std::cos(interface.angladm * std::numbers::pi / 180.0);
    return element.cosine < limit && element.penetration > interface.padm;
}

AdaptiveData::AdaptiveData(const ContactModel& model, const Interface& interface, const ToolSurface& tool,
                           double radius_factor)
    : model_(model), interface_(interface), radius_factor_(radius_factor) {
    curvature_.reserve(static_cast<size_t>(tool.size()));
    for (int s = 0; s < tool.size(); ++s)
        curvature_.push_back(segment_curvature(tool.shape(s)));
}

std::vector<AdaptiveElement> AdaptiveData::elements(const std::vector<NodeContact>& nodes,
                                                    std::span<const Vec3> position) const {
    const auto& segments = model_.surfaces[static_cast<size_t>(interface_.secondary_surface)].segments;
    const auto& secondary = interface_.secondary.node;
    std::vector<AdaptiveElement> elements;
    elements.reserve(segments.size());
    for (const Segment& segment : segments) {
        AdaptiveElement element;
        element.radius = 1e30;
        const int corners = segment.corners();
        for (int j = 0; j < corners; ++j) {
            const int node = segment.node[static_cast<size_t>(j)];
            const int next = segment.node[static_cast<size_t>((j + 1) % corners)];
            const double edge = (position[static_cast<size_t>(node)] - position[static_cast<size_t>(next)]).norm();
            element.longest_edge = std::max(element.longest_edge, edge);
            const auto at = std::lower_bound(secondary.begin(), secondary.end(), node) - secondary.begin();
            const NodeContact& contact = nodes[static_cast<size_t>(at)];
            if (contact.penetration <= 0) continue;
            const SegmentCurvature& curvature = curvature_[static_cast<size_t>(contact.decision.segment)];
            element.radius = std::min(element.radius, curvature.radius);
            element.cosine = std::min(element.cosine, curvature.cosine);
            if (contact.gap > 0) element.penetration = std::max(element.penetration, contact.penetration / contact.gap);
        }
        element.divide = divides(interface_, element, radius_factor_);
        elements.push_back(element);
    }
    return elements;
}

}  // namespace type21::reference
