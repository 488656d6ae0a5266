/// @file The projection in plain double, many nodes at a time, without running bounds: for sub-triangles that are a
/// priori bounded.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "optimized/projection/segment.h"
#include "optimized/simd/simd_width.h"

namespace type21::optimized {

/// Up to `capacity` nodes, each on a sub-triangle of its own. A row holds one number, a column one node.
struct ProjectionBatch {
    static constexpr int capacity = 64;
    using Row = double[capacity];

    // Input.
    alignas(64) Row y[3];                  ///< the node in the tool frame [length]
    alignas(64) Row corner[4][3];          ///< x_j of the segment [length]
    alignas(64) Row normal[4][3];          ///< n_j [-]
    alignas(64) long long code[capacity];  ///< k - 1, of a triangle 4
    alignas(64) Row exclusive_margin;      ///< m(T) of Search; at least 1: no exclusive region
    alignas(64) Row size;                  ///< a_priori_size [length]
    alignas(64) Row gap;                   ///< that decides contact [length]

    // Result. Each number is computed with the operations of filter(), in their order.
    alignas(64) Row b, c;       ///< of Q
    alignas(64) Row lift;       ///< H / <n, N>
    alignas(64) Row n[3];       ///< n
    alignas(64) Row x[3];       ///< X = aA + bB + cC [length]
    alignas(64) Row weight[3];  ///< of step 2: a', b', c'
    alignas(64) Row total;      ///< W of step 2
    alignas(64) Row height;     ///< H
    alignas(64) Row square;     ///< |N|^2
    alignas(64) Row p, q, far;  ///< coordinates of the node in (A, B, C), largest |P - o|
    alignas(64) Row
        certain;  ///< 1: this sub-triangle is retained in contact; -1: nothing is; 0: not known from this projection
    alignas(64) Row rejected;  ///< 1: a weight is surely below its limit; 0: not known

    /// Least weight of step 2, and of step 3.
    double least_w(int i) const { return std::min(weight[0][i], std::min(weight[1][i], weight[2][i])); }
    double least_v(int i) const { return std::min(1 - b[i] - c[i], std::min(b[i], c[i])); }
    /// |h| [length]
    double distance_from_plane(int i) const { return std::abs(height[i]) / std::sqrt(square[i]); }
};

/// Rows of another struct: positions and gaps are read from there, and the results that most callers need are written
/// there.
struct ProjectionRows {
    std::array<const double*, 3> y;
    const double* gap;
    double *b, *c, *lift;
    std::array<double*, 3> n, x;
};
/// The rows of `rows`, from column i on.
template <class Rows>
ProjectionRows rows_from(Rows& rows, int i) {
    return {{rows.y[0] + i, rows.y[1] + i, rows.y[2] + i},
            rows.gap + i,
            rows.b + i,
            rows.c + i,
            rows.lift + i,
            {rows.n[0] + i, rows.n[1] + i, rows.n[2] + i},
            {rows.x[0] + i, rows.x[1] + i, rows.x[2] + i}};
}

/// What holds for all nodes of a tool.
struct BatchLimits {
    double outward, inward;  ///< of CaptureLimits [length]
    double depth;            ///< DEPTH, at most inward [length]
    double proximity;        ///< reach of proximity; a nearer node without contact is not decided here [length]
    bool decide;             ///< false: `certain` is always 0
};

/// Fills the results. `certain` is not 0 where all of these hold: the a priori bounds apply to the node, it lies in the
/// exclusive region, its weights of step 3 are surely accepted, and it clears the plane and its reach by more than
/// rounding.
/// @param first, last  columns first <= c < last, first a multiple of eight; columns up to the next multiple are
/// computed
void project_double(ProjectionBatch& rows, int first, int last, const BatchLimits& limits,
                    SimdWidth machine = this_machine());
/// The same; y and gap are read from `to`, and b, c, lift, n and x written there.
void project_double(ProjectionBatch& rows, const ProjectionRows& to, int first, int last, const BatchLimits& limits,
                    SimdWidth machine = this_machine());

/// Formulation 3, step 6.
inline double kappa_of(double b, double c) {
    return std::abs(1.0 / 3 - b) + std::abs(1.0 / 3 - c) + std::abs(2.0 / 3 - b - c);
}

/// X for given b, c, with the same operations.
V3 point_at(const SegmentData& segment, int triangle, double b, double c);
/// P - X, formed relative to a corner: a distant origin does not matter.
V3 offset_from_point(const V3& p, const SegmentData& segment, int triangle, double b, double c);

}  // namespace type21::optimized
