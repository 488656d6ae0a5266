/// @file The tool in its own frame: coordinates, nodal normals and the boxes that find candidates. Fixed from time 0
/// on.
#pragma once

#include <array>
#include <vector>

#include "reference/contact/sub_triangle.h"
#include "reference/contract/scene.h"

namespace type21::reference {

/// The main surface with y = x - x_G at time 0 (formulation section 1).
/// @manual field surf_IDm, IDrby
class ToolSurface {
  public:
    ToolSurface(const ContactModel& model, const Interface& interface);

    int size() const { return static_cast<int>(segments_.size()); }
    SegmentShape<double> shape(int segment) const;
    /// Indices into Model::nodes of a segment's nodes.
    const std::array<int, 4>& nodes(int segment) const { return segments_[static_cast<size_t>(segment)].node; }
    /// Largest distance of a main node from x_G [length], and that node's tool-frame position.
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
/// rejects.
std::vector<Vec3> nodal_normals(const std::vector<Vec3>& position, const std::vector<std::array<int, 4>>& segments);

}  // namespace type21::reference
