/// @file Where a sub-triangle has no rival, or one neighbour as its only rival.
#pragma once

#include <array>

#include "optimized/search/capture_volume.h"

namespace type21::optimized {

/// A node whose weight of a corner is this large counts as one above that corner. @see Search on corners
constexpr double lead_weight = 0.98;

/// At most six half-spaces, whose complements are not taken by a sub-triangle: a point x with <direction, x> > bound
/// for one line is outside its capture volume. In a section each is a line. Where the three bounds of a side differ,
/// the line lies outside all of them between the lowest and the greatest height.
struct SeparatingLines {
    struct Line {
        V3 direction;
        double bound;
    };
    std::array<Line, 6> line;
    int count = 0;
    double slack = 0;  ///< of the capture volume [length]
};
SeparatingLines separating_lines(const CaptureVolume& volume);

/// The margins m and m2 of a sub-triangle T: points that T takes with weights of at least that size are not taken by
/// its rivals.
class ExclusiveMargins {
  public:
    explicit ExclusiveMargins(const CaptureVolume& own);
    /// Excludes a rival T'. @param side  T' lies over the side opposite to this corner (0, 1, 2); -1: it does not
    void exclude(const SeparatingLines& rival, int side);
    /// Does the rival take no point that T takes with weight `corner` >= lead_weight?
    bool apart_at(const SeparatingLines& rival, int corner) const;
    /// m(T), for all three weights; 1: no such points.
    double exclusive() const { return margin_[3]; }
    /// m2(T), for both weights of any side, where T' over that side counts as no rival; 1: no such points.
    double neighbour_zone() const { return std::max(margin_[0], std::max(margin_[1], margin_[2])); }

  private:
    double bound_of(const SeparatingLines::Line& line) const;

    bool distance_only_;
    double below_;  ///< how far below 0 a weight may go
    double slack_;
    std::array<std::array<V3, 3>, 2> corner_;  ///< at the lowest and at the greatest height
    V3 middle_;
    std::array<double, 4> margin_{};  ///< m2 over sides 0, 1, 2, and m
};

}  // namespace type21::optimized
