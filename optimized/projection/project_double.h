/// @file The projection in plain double, many nodes at a time, without a single bound: for where bounds are known
/// before.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "optimized/projection/segment.h"
#include "optimized/simd/simd_width.h"

namespace type21::optimized {

/// Up to `room` nodes, each on a sub-triangle of its own: a row a number, a column a node.
struct ProjectionBatch {
    static constexpr int room = 64;
    using Row = double[room];

    // Asked.
    alignas(64) Row y[3];              ///< the node in the tool frame [length]
    alignas(64) Row corner[4][3];      ///< x_j of the segment [length]
    alignas(64) Row normal[4][3];      ///< n_j [-]
    alignas(64) long long code[room];  ///< k - 1, of a triangle 4
    alignas(64) Row core;              ///< m(T) of Search; at least 1: none
    alignas(64) Row size;              ///< foreseen_size [length]
    alignas(64) Row gap;               ///< that decides contact [length]

    // Found. Each number is computed with the operations of filter(), in their order.
    alignas(64) Row b, c;       ///< of Q
    alignas(64) Row lift;       ///< H / <n, N>
    alignas(64) Row n[3];       ///< n
    alignas(64) Row x[3];       ///< X = aA + bB + cC [length]
    alignas(64) Row weight[3];  ///< of step 2: a', b', c'
    alignas(64) Row total;      ///< W of step 2
    alignas(64) Row height;     ///< H
    alignas(64) Row square;     ///< |N|^2
    alignas(64) Row p, q, far;  ///< coordinates of the node in (A, B, C), largest |P - o|
    alignas(64) Row certain;    ///< 1: this sub-triangle, contact; -1: nothing; 0: not known from this alone
    alignas(64) Row rejected;   ///< 1: a weight is surely below its limit, in a foreseen sub-triangle; 0: not known

    /// Smallest weight of step 2, and of step 3.
    double innermost(int i) const { return std::min(weight[0][i], std::min(weight[1][i], weight[2][i])); }
    double least_landed(int i) const { return std::min(1 - b[i] - c[i], std::min(b[i], c[i])); }
    /// Of the node over the plane, without sign [length]
    double distance_from_plane(int i) const { return std::abs(height[i]) / std::sqrt(square[i]); }
};

/// Where nodes stand, and where it is put what most of them are asked for: in rows of others, from their first column
/// on.
struct LandingPlace {
    std::array<const double*, 3> y;
    const double* gap;
    double *b, *c, *lift;
    std::array<double*, 3> n, x;
};
/// Those of `rows` from column i on.
template <class Rows>
LandingPlace place_in(Rows& rows, int i) {
    return {{rows.y[0] + i, rows.y[1] + i, rows.y[2] + i},
            rows.gap + i,
            rows.b + i,
            rows.c + i,
            rows.lift + i,
            {rows.n[0] + i, rows.n[1] + i, rows.n[2] + i},
            {rows.x[0] + i, rows.x[1] + i, rows.x[2] + i}};
}

/// What holds for all nodes of a tool.
struct LandingLimits {
    double outward, inward;  ///< Search::limits [length]
    double depth;            ///< DEPTH of the window, at most inward [length]
    double proximity;        ///< of the window: nearer than this is not decided where it is no contact [length]
    bool decide;             ///< may `certain` be anything but 0?
};

/// Fills what is found. `certain` is not 0 where the node is one for which bounds were foreseen (foreseen_bounds.h), it
/// lies in the core, lands where it is surely taken, off the plane and away from its reach by more than rounding.
/// @param first, last  columns, first a multiple of eight; those up to the next one behind the last are computed too
void project_double(ProjectionBatch& rows, int first, int last, const LandingLimits& limits,
                    SimdWidth machine = this_machine());
/// The same; y and gap are taken from there, and b, c, lift, n and x put there.
void project_double(ProjectionBatch& rows, const LandingPlace& place, int first, int last, const LandingLimits& limits,
                    SimdWidth machine = this_machine());

/// Step 6.
inline double kappa_of(double b, double c) {
    return std::abs(1.0 / 3 - b) + std::abs(1.0 / 3 - c) + std::abs(2.0 / 3 - b - c);
}

/// X of a node that has come to b, c otherwise, with the same operations.
V3 landed_at(const SegmentData& segment, int piece, double b, double c);
/// P - X, formed where a distant origin does not matter.
V3 offset_from_landing(const V3& p, const SegmentData& segment, int piece, double b, double c);

}  // namespace type21::optimized
