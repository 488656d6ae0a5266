/// @file Exact ties of structured meshes, proven without evaluating kappa.
#pragma once

#include <span>

#include "optimized/projection/filter.h"
#include "optimized/projection/sub_triangle_id.h"

namespace type21::optimized {

/// A sub-triangle that may be retained.
struct Contender {
    SubTriangleId id;
    Kind kind;         ///< not proven when unsure
    bool unsure;       ///< the filter could not tell whether it takes the node
    double low, high;  ///< bounds of kappa; not set when unsure
};

/// kappa of a sub-triangle that takes the node from above one of its corners.
constexpr double kappa_above_corner = 4.0 / 3;

/// Proven: all of these sub-triangles take the node with exactly the same kappa.
///
/// Assumed: each is proven to take the node, by filter() or within its a priori bounds. Then <n_V, N> > 0 is proven at
/// its three corners. A corner is a node of the segment, or the centre of a quad with the mean of its four normals.
/// kappa is the sum of |1/3 - w| over the three weights, so equal weights in any order give equal kappa.
///
/// Above a corner V, P - V is parallel to n_V. V is lifted to P itself, all weight is on V, n = n_V and Q = V. So kappa
/// = 4/3 for every sub-triangle with this corner.
///
/// Over a common side V W, the vectors P - V, W - V, n_V and n_W lie in one plane F. Since <n_V, N> > 0, F is not
/// parallel to the sub-triangle. P and the lifted corners V', W' and U' lie in a plane parallel to the sub-triangle. F
/// cuts it in a line along the side, which holds P, V' and W' but not U'. So U' has no weight. For vectors x in F,
/// <x, N> is a multiple of the part of x across the side, and the factor cancels in H / <n_V, N>. So V' and W' are the
/// same points for both sub-triangles, and the weights, n and Q agree.
///
/// In one quad whose corners form an exact parallelogram (x_1 + x_3 = x_2 + x_4), with one normal at all of them,
/// sub-triangles k and k + 1 have the same N and the same Q. Let b, c be the weights of x_k and x_{k+1} in k. Those in
/// k + 1 are (1 - c + b, c, -b). Where |b| <= c - 2/3, both kappas are 2 c - 2/3.
///
/// Ties are transitive.
///
/// @param segments  of each contender
bool tied(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
          const ContactReach& reach, const ProjectionLimits& rules);

/// A corner V with the node exactly above it.
///
/// Let T' be another sub-triangle with this corner and <n_V, N'> != 0. T' takes the node with kappa = 4/3, or not at
/// all. If P = V, H' = 0 and nothing is lifted: all weight is on V, n = n_V, and step 3 rejects a negative slope. If P
/// != V, H' is a multiple of <n_V, N'> and not zero: step 1 rejects a negative slope, and a positive one lifts V to P.
/// If <n_V, N'> = 0 nothing can be said, since T' does not lift a node in its plane.
struct TieCorner {
    int centre_of = -1;  ///< segment of which it is the centre; -1: it is a node
    V3 at, normal;       ///< of a node

    /// Which corner of a sub-triangle it is: 0: A, 1: B, 2: C, -1: none.
    int index_in(SubTriangleId id, const SegmentData& s) const {
        if (centre_of >= 0) return id.segment() == centre_of ? 0 : -1;
        const SubTriangleCorners k = sub_triangle_corners(s.is_triangle, id.triangle());
        if (is(s, k.b)) return 1;
        if (is(s, k.c)) return 2;
        return s.is_triangle && is(s, 2) ? 0 : -1;
    }
    bool of(SubTriangleId id, const SegmentData& s) const { return index_in(id, s) >= 0; }

  private:
    bool is(const SegmentData& s, int j) const {
        const V3 &x = s.node[static_cast<size_t>(j)], &n = s.normal[static_cast<size_t>(j)];
        return x.x == at.x && x.y == at.y && x.z == at.z && n.x == normal.x && n.y == normal.y && n.z == normal.z;
    }
};

/// Proven: the node is exactly above a corner of this sub-triangle, which is filled.
bool corner_below(const V3& p, SubTriangleId id, const SegmentData& segment, TieCorner& corner);

/// Proven: the node is exactly above this corner of sub-triangle k. @param corner  0: A, 1: B, 2: C
bool above_corner(const V3& p, const SegmentData& segment, int k, int corner);

/// Proven: the node, the side opposite to this corner and the normals at the ends of the side lie in one plane.
bool over_side(const V3& p, const SegmentData& segment, int k, int corner);

}  // namespace type21::optimized
