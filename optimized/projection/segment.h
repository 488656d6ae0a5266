/// @file The input of a decision: a segment with its normals, reaches and limits.
#pragma once

#include <array>

#include "optimized/projection/vector3.h"

namespace type21::optimized {

/// A main segment in the tool frame, as given. A triangle repeats its third node.
struct SegmentData {
    std::array<V3, 4> node;    ///< x_j [length]
    std::array<V3, 4> normal;  ///< n_j, of any length [-]
    bool is_triangle = false;

    int sub_triangles() const { return is_triangle ? 1 : 4; }
};

/// Corners B and C of sub-triangle k as corners of the segment; A is the centre of a quad and corner 2 of a triangle.
/// Source: Formulation 1, step 3.
struct SubTriangleCorners {
    int b, c;
};
inline SubTriangleCorners sub_triangle_corners(bool is_triangle, int k) {
    if (is_triangle) return {0, 1};
    return {k - 1, k % 4};
}

/// How far the tool takes a node: Formulation 3, step 5.
struct ContactReach {
    double gap = 0;        ///< g [length]
    double depth = 0;      ///< DEPTH [length]
    double proximity = 0;  ///< largest reach of the active effects, 0: none [length]
};

/// What a departure changes in a decision.
struct ProjectionLimits {
    double low = -0.01;               ///< a weight below it is outside; -0.05 in the first look of D31
    double high = 1.01;               ///< b + c above it is outside; 1.05 with D31
    bool proximity_competes = false;  ///< D11: contact and proximity compete on kappa alone
    bool lift_leaning = false;        ///< D35: <n_V, N> <= 0 is lifted with 1e-30 in its place
};

/// D35's stand-in for a slope that is not positive.
constexpr double leaning_guard = 1e-30;

}  // namespace type21::optimized
