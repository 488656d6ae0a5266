/// @file What adaptive meshing needs to know of the contact (Formulation 9, step 15). No element is divided here.
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

/// @param segment  corners and nodal normals of one main segment, any frame
/// @return radius and cosine.  Formulation 9, step 15.
/// @manual comment 3
SegmentCurvature segment_curvature(const SegmentShape<double>& segment);

/// Iadm 1: radius < longest edge.  Iadm 2: radius < NRadm x longest edge, or the angle between normals is larger than
/// Angladm and the penetration, as a share of the gap, larger than Padm.
/// @param element        radius, cosine, penetration and longest edge; its `divide` is not read
/// @param radius_factor  on the radius to be kept: 1; as built: D37 [-]
/// @return whether the element is to be divided.  Formulation 9, step 15; manual page, comment 3.
/// @manual field Iadm, NRadm, Padm, Angladm; comment 3; departure D37
bool divides(const Interface& interface, const AdaptiveElement& element, double radius_factor = 1.0);

/// Curvature of each main segment. Present only when the card asks for Iadm.
class AdaptiveData {
  public:
    /// @param radius_factor  of divides()
    AdaptiveData(const ContactModel& model, const Interface& interface, const ToolSurface& tool, double radius_factor);

    /// One entry for each segment of the secondary surface.
    /// @param nodes     of this cycle, one for each of SecondarySide::node
    /// @param position  of each of ContactModel::nodes [length]
    std::vector<AdaptiveElement> elements(const std::vector<NodeContact>& nodes, std::span<const Vec3> position) const;

  private:
    const ContactModel& model_;
    const Interface& interface_;
    double radius_factor_;
    std::vector<SegmentCurvature> curvature_;
};

}  // namespace type21::reference
