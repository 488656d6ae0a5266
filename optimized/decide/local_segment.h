/// @file A segment seen from its own first corner, in double, with what the error bounds need.
#pragma once

#include "optimized/decide/segment.h"

namespace type21::optimized {

/// Coordinates relative to the origin o = x_1 (quad) or x_3 (triangle, which is its A): how far the tool lies from its
/// own origin costs no accuracy then.
struct LocalSegment {
    V3 origin;
    std::array<V3, 4> corner;  ///< x_j - o, each rounded once
    V3 center;                 ///< A - o; exactly zero for a triangle
    V3 center_normal;          ///< n_A
    double extent = 0;         ///< largest |x_j - o| in the maximum norm
    double normal_size = 0;    ///< largest |n_j| in the maximum norm
};

inline LocalSegment local_segment(const SegmentData& s) {
    LocalSegment l;
    l.origin = s.triangle ? s.node[2] : s.node[0];
    for (size_t j = 0; j < 4; ++j) {
        l.corner[j] = s.node[j] - l.origin;
        l.extent = std::max(l.extent, largest(l.corner[j]));
        l.normal_size = std::max(l.normal_size, largest(s.normal[j]));
    }
    if (s.triangle) {
        l.center_normal = s.normal[2];
    } else {
        l.center = (l.corner[1] + l.corner[2] + l.corner[3]) * 0.25;
        l.center_normal = ((s.normal[0] + s.normal[1]) + (s.normal[2] + s.normal[3])) * 0.25;
    }
    return l;
}

}  // namespace type21::optimized
