#include "optimized/kernel/adaptive_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace type21::optimized {

namespace {

constexpr double flat = 1e-20;  ///< least change of the normal per length: a flat segment has the radius 1e20 L

/// Radius of the arc whose mid-line is `along` and over which the normal turns by `turn`.
double radius(const V3& along, const V3& turn) {
    const double length = norm(along);
    if (length == 0) return 1 / flat;
    return length / std::max(flat, std::abs(dot(turn, along) / length));
}

}  // namespace

AdaptiveLaw::AdaptiveLaw(const ContactModel& model, const Interface& interface, const Tool& tool)
    : card_(interface),
      blank_(model.surfaces[static_cast<size_t>(interface.secondary_surface)].segments),
      factor_((model.as_built.has(Departure::D37) ? std::numbers::sqrt2 : 1.0) *
              (interface.iadm == 2 ? double(interface.nradm) : 1.0)) {
    for (int s = 0; s < tool.size(); ++s) {
        const SegmentData segment = tool.segment(s);
        const auto& x = segment.node;
        const auto& n = segment.normal;
        Curvature c;
        c.radius = std::min(radius((x[1] + x[2]) - (x[0] + x[3]), (n[1] + n[2]) - (n[0] + n[3])),
                            radius((x[3] + x[2]) - (x[0] + x[1]), (n[3] + n[2]) - (n[0] + n[1])));
        const V3 area = cross(x[2] - x[0], x[3] - x[1]);
        const double size = norm(area);
        for (const V3& normal : n)
            c.cosine = std::min(c.cosine, size > 0 ? dot(area, normal) / size : 0.0);
        curvature_.push_back(c);
    }
    const auto& nodes = interface.secondary.node;
    for (const Segment& segment : blank_) {
        std::array<int, 4> rank{};
        for (size_t j = 0; j < 4; ++j)
            rank[j] = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), segment.node[j]) - nodes.begin());
        rank_.push_back(rank);
    }
}

bool AdaptiveLaw::divides(const AdaptiveElement& element) const {
    if (element.radius < factor_ * element.longest_edge) return true;
    const double sharpest = std::cos(card_.angladm * std::numbers::pi / 180);
    return card_.iadm == 2 && element.cosine < sharpest && element.penetration > card_.padm;
}

std::vector<AdaptiveElement> AdaptiveLaw::elements(const std::vector<NodeContact>& nodes,
                                                   std::span<const Vec3> position) const {
    std::vector<AdaptiveElement> elements(blank_.size());
    for (size_t e = 0; e < elements.size(); ++e) {
        AdaptiveElement& element = elements[e];
        element.radius = 1e30;
        const auto corners = static_cast<size_t>(blank_[e].corners());
        for (size_t j = 0; j < corners; ++j) {
            const Vec3& here = position[static_cast<size_t>(blank_[e].node[j])];
            const Vec3& there = position[static_cast<size_t>(blank_[e].node[(j + 1) % corners])];
            element.longest_edge = std::max(element.longest_edge, (here - there).norm());
            const NodeContact& node = nodes[static_cast<size_t>(rank_[e][j])];
            if (!(node.penetration > 0)) continue;
            const Curvature& c = curvature_[static_cast<size_t>(node.decision.segment)];
            element.radius = std::min(element.radius, c.radius);
            element.cosine = std::min(element.cosine, c.cosine);
            if (node.gap > 0) element.penetration = std::max(element.penetration, node.penetration / node.gap);
        }
        element.divide = divides(element);
    }
    return elements;
}

}  // namespace type21::optimized
