/// @file Data for adaptive meshing (manual page, comment 3; Formulation 9, step 15).
#pragma once

#include <span>
#include <vector>

#include "optimized/search/tool.h"
#include "reference/contract/contact_step.h"

namespace type21::optimized {

/// Curvature of each main segment: smallest radius over its two mid-lines, L / |<dn, e>|, and the smallest cosine
/// between its facet and its nodal normals.
/// @manual field Iadm, NRadm, Padm, Angladm; comment 3; departure D37
class AdaptiveLaw {
  public:
    AdaptiveLaw(const ContactModel& model, const Interface& interface, const Tool& tool);
    /// One entry for each segment of the secondary surface.
    std::vector<AdaptiveElement> elements(const std::vector<NodeContact>& nodes, std::span<const Vec3> position) const;

  private:
    bool divides(const AdaptiveElement& element) const;

    struct Curvature {
        double radius = 0, cosine = 1;
    };
    const Interface& card_;
    const std::vector<Segment>& blank_;
    double factor_;
    std::vector<Curvature> curvature_;
    std::vector<std::array<int, 4>> rank_;  ///< of the corners of each blank segment among the secondary nodes
};

}  // namespace type21::optimized
