/// @file Exact ties of structured meshes, known without evaluating anything exactly.
#pragma once

#include <span>

#include "optimized/decide/filter.h"

namespace type21::optimized {

/// A sub-triangle that may be retained.
struct Contender {
    int segment, piece;
    Kind kind;         ///< not proven when unsure
    bool unsure;       ///< the filter could not tell
    double low, high;  ///< kappa lies between them; not when unsure
};

/// Proven: all of these sub-triangles take the node with the very same kappa. All must be proven to take it. kappa =
/// sum over the three weights w of |1/3 - w|, so equal weights in any order are equal kappa.
///
/// At a vertex V that is a corner of each, with P - V parallel to n_V: V is lifted to P itself in each, so all weight
/// is on V, n = n_V, Q = V, kappa = 4/3.
///
/// Over an edge V W that is a side of each, where an axis i has V_i = W_i = P_i and n_V, n_W have no component i, and
/// the third corner U has U_i != V_i. Edge, both normals and P lie in the plane x_i = V_i. P, the lifted V', W' and U'
/// lie in a plane parallel to the sub-triangle; it cuts x_i = V_i in a line along the edge (it is not parallel to it:
/// U), which holds V', W', P: U' has no weight. <x, N> of vectors in x_i = V_i is a multiple of their part across the
/// edge, and the multiplier cancels in H / <n_V, N>: V', W', hence the weights, n, Q and the final weights are the same
/// for each sub-triangle.
///
/// In one quad whose corners form an exact parallelogram (x_1 + x_3 = x_2 + x_4) with one normal at all of them: pieces
/// k and k + 1 have the same N and land the node at the same Q. With b, c the weights of x_k and x_{k+1} in piece k,
/// those in piece k + 1 are (1 - c + b, c, -b). Where |b| <= c - 2/3 both kappa are 2 c - 2/3.
///
/// @param segments  of each contender
bool tied(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
          const Window& window, const Rules& rules);

}  // namespace type21::optimized
