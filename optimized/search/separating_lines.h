/// @file Where a sub-triangle has a node to itself, or shares it with one neighbour only.
#pragma once

#include <array>

#include "optimized/search/capture_volume.h"

namespace type21::optimized {

/// A weight that is this large is one of a node above a corner; @see Search on corners.
constexpr double lead_weight = 0.98;

/// Six lines at most, line = (direction, bound): a point x with <direction, x> > bound for any one of them is not
/// taken by the sub-triangle. @see Prism; where the three bounds of a side differ, the line lies outside of all of them
/// between the lowest and the greatest height.
struct SeparatingLines {
    struct Line {
        V3 direction;
        double bound;
    };
    std::array<Line, 6> line;
    int count = 0;
    double slack = 0;  ///< of the prism [length]
};
SeparatingLines outer_lines(const CaptureVolume& prism);

/// The margins m of a sub-triangle T: points that T takes with large enough weights are taken by no other.
class ExclusiveMargins {
  public:
    explicit ExclusiveMargins(const CaptureVolume& own);
    /// @param side  T' lies over the side opposite to this weight (0, 1, 2), -1: it does not
    void keep_from(const SeparatingLines& other, int side);
    /// Does the other take no point that this one takes with weight `corner` >= lead_weight?
    bool apart_at(const SeparatingLines& other, int corner) const;
    /// Points with all weights >= this are taken by T alone; 1: none.
    double alone() const { return margin_[3]; }
    /// Likewise points with both weights of a side >= this, by T and the one over that side; 1: none.
    double pair() const { return std::max(margin_[0], std::max(margin_[1], margin_[2])); }

  private:
    double bound_of(const SeparatingLines::Line& line) const;

    bool grown_;
    double below_;  ///< how far below 0 a weight may go
    double slack_;
    std::array<std::array<V3, 3>, 2> corner_;  ///< at the lowest and at the greatest height
    V3 middle_;
    std::array<double, 4> margin_{};  ///< of pairs over sides 0, 1, 2, alone
};

}  // namespace type21::optimized
