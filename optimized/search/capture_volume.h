/// @file Where in space a sub-triangle can take a node at all: a region that provably holds every such point.
#pragma once

#include "optimized/projection/segment.h"
#include "optimized/search/box.h"

namespace type21::optimized {

/// What bounds the regions of all sub-triangles of a tool.
struct Limits {
    double outward = 0;         ///< largest of the gaps and of the proximity reach, over all nodes [length]
    double inward = 0;          ///< DEPTH [length]
    double margin = 0.01;       ///< how far below 0 a weight may go; 0.05 where D31 looks so
    bool lift_leaning = false;  ///< D35
};

/// A node P that sub-triangle (A, B, C) takes has, by steps 1 to 5 of formulation section 3, a height -inward <= h <=
/// outward over its plane and lies in the lifted triangle of that height with weights >= -margin:
///   P = sum w_V (V + h rise_V),   rise_V = n_V / <n_V, N^>,   w_V >= -margin,  sum w_V = 1,
/// N^ the unit normal of the plane. So it lies in the hull of the triangle's corners drawn out to those weights, which
/// move along straight lines as h grows.
/// It satisfies, too, |P - T| < max(outward, inward), T the closed triangle, since the clipped point lies in T. Where
/// the first statement says little (slivers, normals that lean far) the second alone is used: "grown".
/// All is computed in double; slack covers its rounding: the relative error of N is below 1e-11 here (else grown; edges
/// are formed from one corner, so that a distant origin does not matter), no slope is below 0.05, so positions are off
/// by less than 1e-8 of the size.
struct CaptureVolume {
    bool grown = false;
    std::array<V3, 3> corner;   ///< A, B, C [length]
    std::array<V3, 3> rise;     ///< of each corner per height [-]
    V3 axis;                    ///< N^
    std::array<V3, 3> outward;  ///< unit normals in the plane, of the side opposite to each corner
    /// <outward_i, P - A> <= max over the drawn-out corners c of rim_ic + h lean_ic.
    std::array<std::array<double, 3>, 3> rim{}, lean{};
    double low = 0, high = 0;  ///< of h [length]
    double margin = 0;         ///< Limits::margin
    double slack = 0;          ///< [length]
    double growth = 0;         ///< max(outward, inward) [length]

    /// A proven lower bound on the distance of y from every point that the sub-triangle takes; <= 0 says nothing.
    double clearance(const V3& y) const;
    Box box() const;
};

CaptureVolume prism(const SegmentData& segment, int k, const Limits& limits);

}  // namespace type21::optimized
