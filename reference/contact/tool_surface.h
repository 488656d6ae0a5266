/// @file The tool in its own frame: coordinates and nodal normals, fixed from time 0 on (chapter 1 of the formulation).
#pragma once

#include <array>
#include <vector>

#include "reference/contact/sub_triangle.h"
#include "reference/contract/scene.h"

namespace type21::reference {

/// The main surface with y = x - x_G at time 0.  Formulation 1, step 1; Formulation 1, step 4.
/// @manual field surf_IDm, IDrby
class ToolSurface {
  public:
    ToolSurface(const ContactModel& model, const Interface& interface);

    /// Number of segments.
    int size() const { return static_cast<int>(segments_.size()); }
    /// Corners and their normals in the tool frame.
    /// @param segment  rank in the main surface, not checked
    SegmentShape<double> shape(int segment) const;
    /// Indices into ContactModel::nodes of a segment's nodes.
    const std::array<int, 4>& nodes(int segment) const { return segments_[static_cast<size_t>(segment)].node; }
    /// The main node farthest from x_G, in the tool frame [length].
    const Vec3& farthest() const { return farthest_; }

  private:
    std::vector<Segment> segments_;
    std::vector<std::array<int, 4>> local_;  ///< corner -> rank in position_ and normal_
    std::vector<Vec3> position_;
    std::vector<Vec3> normal_;
    Vec3 farthest_ = Vec3::Zero();
};

/// Nodal normals: the sum of the unit normals of the adjacent sub-triangles (quad corner: its two; triangle corner: its
/// one), normalised; no area or angle weight. A node whose sum is zero gets the zero vector, which every projection
/// of a node off the plane rejects.
/// @param position  of the main nodes, tool frame [length]
/// @param segments  ranks into position; a triangle repeats its third
/// @return one unit vector or zero a node, global axes at time 0 [-].  Formulation 1, step 4.
/// @manual field surf_IDm
std::vector<Vec3> nodal_normals(const std::vector<Vec3>& position, const std::vector<std::array<int, 4>>& segments);

}  // namespace type21::reference
