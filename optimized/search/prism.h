/// @file Where in space a sub-triangle can take a node at all: a region that provably holds every such point.
#pragma once

#include "optimized/decide/segment.h"
#include "optimized/search/box.h"

namespace type21::optimized {

/// What bounds the regions of all sub-triangles of a tool.
struct Limits {
    double outward = 0;         ///< largest of the gaps and of the proximity reach, over all nodes [length]
    double inward = 0;          ///< DEPTH [length]
    double margin = 0.01;       ///< how far below 0 a weight may go; 0.05 where D31 looks so
    bool lift_leaning = false;  ///< D35
};

/// A node P that sub-triangle (A, B, C) takes satisfies, by steps 1 to 5 of formulation section 3,
///   P = Q + h (N^ + tau),   Q in the plane with weights >= -margin,   -inward <= h <= outward,
/// N^ the unit normal of the plane, h the height of P over it, tau the way sideways per height of the interpolated
/// normal: n = sum w_V n_V with weights w_V >= -margin, so tau = sum l_V tau_V with l_V = w_V s_V / sum w s, s_V =
/// <n_V, N^>, tau_V = n_V / s_V - N^. Where all s_V > 0, l_V >= -spread with
///   spread = margin s_max / (s_min - 2 margin (s_max - s_min)),
/// so tau lies in the triangle of the tau_V, grown about its middle by that spread.
/// It satisfies, too, |P - T| < max(outward, inward), T the closed triangle, since the clipped point lies in T. Where
/// the first statement says little (slivers, normals that lean far) the second alone is used: "grown".
/// All is computed in double; slack covers its rounding: the relative error of N is below 1e-11 here (else grown), no
/// slope is below 0.05, so positions are off by less than 1e-8 of the size.
struct Prism {
    bool grown = false;
    std::array<V3, 3> corner;                       ///< A, B, C
    std::array<V3, 3> reached;                      ///< corners of the triangle of all Q
    V3 axis;                                        ///< N^
    std::array<V3, 3> outward;                      ///< unit normals in the plane, of the side opposite to each corner
    std::array<double, 3> rim{};                    ///< <outward_i, Q - A> <= rim_i
    std::array<V3, 3> lean;                         ///< corners of the triangle of all tau
    std::array<double, 3> lean_low{}, lean_high{};  ///< of <outward_i, tau>
    double low = 0, high = 0;                       ///< of h [length]
    double slack = 0;                               ///< [length]
    double growth = 0;                              ///< max(outward, inward) [length]

    /// A proven lower bound on the distance of y from every point that the sub-triangle takes; <= 0 says nothing.
    double clearance(const V3& y) const;
    Box box() const;
};

Prism prism(const SegmentData& segment, int k, const Limits& limits);

/// The smallest m such that no point that `core` takes with all weights >= m is taken by `other`; 1 where there is
/// none. @see Cores
double margin_apart(const Prism& core, const Prism& other);

}  // namespace type21::optimized
