/// @file Exact ties of structured meshes, known without evaluating anything exactly.
#pragma once

#include <span>

#include "optimized/projection/filter.h"

namespace type21::optimized {

/// A sub-triangle that may be retained.
struct Contender {
    int segment, piece;
    Kind kind;         ///< not proven when unsure
    bool unsure;       ///< the filter could not tell
    double low, high;  ///< kappa lies between them; not when unsure
};

/// Proven: all of these sub-triangles take the node with the very same kappa. All must be proven to take it, by
/// filter(), which proves <n_V, N> > 0 at their corners then. kappa = sum over the three weights w of |1/3 - w|, so
/// equal weights in any order are equal kappa. Corners are the nodes of a segment and the centre of a quad with the
/// mean of its normals.
///
/// Above a corner V, P - V parallel to n_V: V is lifted to P itself, so all weight is on V, n = n_V, Q = V, kappa = 4/3
/// for each sub-triangle that has such a corner.
///
/// Over an edge V W that is a side of both, where P - V, W - V, n_V and n_W lie in one plane E. E is not parallel to
/// the sub-triangle, for n_V is not. P, the lifted V', W' and U' of the third corner lie in a plane parallel to the
/// sub-triangle, which cuts E in a line along the edge that holds V', W', P and not U', for U is not in E: U' has no
/// weight. <x, N> of vectors in E is a multiple of their part across the edge, and the multiplier cancels in H / <n_V,
/// N>: V', W', hence the weights, n, Q and the final weights are the same for both.
///
/// In one quad whose corners form an exact parallelogram (x_1 + x_3 = x_2 + x_4) with one normal at all of them: pieces
/// k and k + 1 have the same N and land the node at the same Q. With b, c the weights of x_k and x_{k+1} in piece k,
/// those in piece k + 1 are (1 - c + b, c, -b). Where |b| <= c - 2/3 both kappa are 2 c - 2/3.
///
/// What is tied with one of two that are tied is tied with the other.
///
/// @param segments  of each contender
bool tied(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
          const ContactReach& window, const ProjectionLimits& rules);

constexpr double kappa_on_corner = 4.0 / 3;

/// A corner below a node.
struct TieCorner {
    int centre_of = -1;  ///< segment of which it is the centre; -1: it is a node
    V3 at, normal;       ///< of a node

    /// Which corner of a sub-triangle it is: 0: A, 1: B, 2: C, -1: none.
    int index_in(int rank, const SegmentData& s, int piece) const {
        if (centre_of >= 0) return rank == centre_of ? 0 : -1;
        const PieceCorners k = piece_corners(s.triangle, piece);
        if (is(s, k.b)) return 1;
        if (is(s, k.c)) return 2;
        return s.triangle && is(s, 2) ? 0 : -1;
    }
    bool of(int rank, const SegmentData& s, int piece) const { return index_in(rank, s, piece) >= 0; }

  private:
    bool is(const SegmentData& s, int j) const {
        const V3 &x = s.node[static_cast<size_t>(j)], &n = s.normal[static_cast<size_t>(j)];
        return x.x == at.x && x.y == at.y && x.z == at.z && n.x == normal.x && n.y == normal.y && n.z == normal.z;
    }
};

/// Proven: P lies exactly above a corner of sub-triangle k, which is filled.
bool corner_below(const V3& p, int rank, const SegmentData& segment, int k, TieCorner& corner);

/// Proven: P lies exactly above a corner. @param corner  0: A, 1: B, 2: C of sub-triangle k
bool above_corner(const V3& p, const SegmentData& segment, int k, int corner);

/// Proven: P, the side opposite to that corner and the normals at its ends lie in one plane.
bool over_side(const V3& p, const SegmentData& segment, int k, int corner);

}  // namespace type21::optimized
