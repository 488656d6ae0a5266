/// @file Which segments may reach a node: every segment whose box, grown by the farthest reach, holds
/// it (Formulation 4, step 1).
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "reference/contact/tool_surface.h"

namespace type21::reference {

/// Boxes of the segments in the tool frame, in a tree of boxes that only skips what cannot hold the point.
///
/// Complete by construction: a node in contact or proximity lies nearer than the largest of g, DEPTH and the proximity
/// reach to a point whose weights are in [0, 1] with the sum 1, which is a point of the segment's box; so it lies in
/// that box grown by this reach. The box of a branch holds the boxes below it. Rounding is covered by a growth of 1e-9
/// of the tool's size.
class Candidates {
  public:
    /// @param reach  largest of all gaps, DEPTH and the reach of heat [length]
    Candidates(const ToolSurface& tool, double reach);

    /// Ranks of the segments that may reach y, ascending; none for a y that is not finite.
    /// @param y  node in the tool frame [length]
    std::vector<int> at(const Vec3& y) const;

  private:
    using Box = Eigen::AlignedBox3d;
    struct Branch {
        Box box;
        int first = 0;   ///< of order_ when a leaf
        int count = 0;   ///< > 0: a leaf
        int below = -1;  ///< first of two branches when not a leaf
    };

    void build(int branch, int first, int count);

    std::vector<Box> boxes_;
    std::vector<int> order_;
    std::vector<Branch> branches_;
};

}  // namespace type21::reference
