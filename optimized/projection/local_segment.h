/// @file A segment seen from its own first corner, in double, with what the error bounds need.
#pragma once

#include "optimized/projection/segment.h"

namespace type21::optimized {

/// Coordinates relative to the origin o = x_1 (quad) or x_3 (triangle, which is its A). So a
/// tool far from its own origin loses no accuracy.
template <class Real>
struct LocalSegmentIn {
    V3 origin;
    std::array<Triple<Real>, 4> corner;  ///< x_j - o, each rounded once
    Triple<Real> center;                 ///< A - o; exactly zero for a triangle
    Triple<Real> center_normal;          ///< n_A
    double extent = 0;                   ///< largest |x_j - o| in the maximum norm
    double normal_size = 0;              ///< largest |n_j| in the maximum norm
};

template <class Real>
TYPE21_INLINE Triple<Real> widened(const V3& v) {
    return {Real(v.x), Real(v.y), Real(v.z)};
}

template <class Real>
TYPE21_INLINE LocalSegmentIn<Real> local_segment_in(const SegmentData& s) {
    LocalSegmentIn<Real> l;
    l.origin = s.is_triangle ? s.node[2] : s.node[0];
    const Triple<Real> o = widened<Real>(l.origin);
    const Real quarter(0.25);
    for (size_t j = 0; j < 4; ++j) {
        l.corner[j] = widened<Real>(s.node[j]) - o;
        l.extent = std::max(l.extent, largest(l.corner[j]));
        l.normal_size = std::max(l.normal_size, largest(s.normal[j]));
    }
    const auto n = [&](size_t j) { return widened<Real>(s.normal[j]); };
    if (s.is_triangle) {
        l.center_normal = n(2);
    } else {
        l.center = (l.corner[1] + l.corner[2] + l.corner[3]) * quarter;
        l.center_normal = ((n(0) + n(1)) + (n(2) + n(3))) * quarter;
    }
    return l;
}

using LocalSegment = LocalSegmentIn<double>;
inline LocalSegment local_segment(const SegmentData& s) {
    return local_segment_in<double>(s);
}

}  // namespace type21::optimized
