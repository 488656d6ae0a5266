/// @file What adaptive meshing needs to know of the contact (page comment 3, formulation section 9). Division itself is
/// outside.
#pragma once

#include <span>
#include <vector>

#include "reference/contact/tool_surface.h"
#include "reference/contract/contact_step.h"

namespace type21::reference {

/// Curvature of one main segment, from the way its nodal normals turn.
struct SegmentCurvature {
    double radius = 0;  ///< smallest over the two mid-lines: L / |<dn, e>| [length], 1e20 L where flat
    double cosine = 1;  ///< smallest <facet normal, nodal normal> over the corners [-]
};

SegmentCurvature segment_curvature(const SegmentShape<double>& segment);

/// Iadm 1: radius < longest edge.  Iadm 2: radius < NRadm x longest edge, or the angle between normals is larger than
/// Angladm and the penetration, as a share of the gap, larger than Padm.  D37: sqrt(2) times that radius.
/// @manual field Iadm, NRadm, Padm, Angladm; comment 3; departure D37
bool divides(const Interface& interface, const AdaptiveElement& element, const AsBuilt& as_built);

/// The room of Iadm: curvature of each main segment. Present only when the card asks for it.
class AdaptiveData {
  public:
    AdaptiveData(const ContactModel& model, const Interface& interface, const ToolSurface& tool);

    /// One entry for each segment of the secondary surface.
    std::vector<AdaptiveElement> elements(const std::vector<NodeContact>& nodes, std::span<const Vec3> position) const;

  private:
    const ContactModel& model_;
    const Interface& interface_;
    std::vector<SegmentCurvature> curvature_;
};

}  // namespace type21::reference
