/// @file Capture volume: a region that provably holds every point where a sub-triangle can take a node.
#pragma once

#include "optimized/projection/segment.h"
#include "optimized/search/box.h"

namespace type21::optimized {

/// What bounds the capture volumes of all sub-triangles of a tool.
struct CaptureLimits {
    double outward = 0;         ///< largest of the gaps and of the proximity reach, over all nodes [length]
    double inward = 0;          ///< DEPTH [length]
    double margin = 0.01;       ///< how far below 0 a weight may go; 0.05 with D31
    bool lift_leaning = false;  ///< D35
};

/// A node P that sub-triangle (A, B, C) takes has, by Formulation 3, steps 1 to 5, a height -inward <= h <= outward
/// over its plane, and lies in the lifted triangle of that height with weights >= -margin:
///   P = sum w_V (V + h rise_V),   rise_V = n_V / <n_V, N^>,   w_V >= -margin,  sum w_V = 1,
/// N^ the unit normal of the plane. For a fixed h these points are a triangle whose corners are drawn out to those
/// weights. The corners move along straight lines as h grows, so the volume lies in the hull of six points.
///
/// P satisfies |P - t| < max(outward, inward) as well, t the nearest point of the closed triangle, since the clipped
/// point lies in it. Where the first statement says little (slivers, normals that lean far), only this one is used:
/// `distance_only`.
///
/// If a slope <n_V, N^> is negative, the sub-triangle rejects every node off its plane, and lifts none in it. Then h =
/// 0 and rise_V = 0. The same holds for a slope that is exactly zero; it falls under `distance_only`, which includes
/// it.
///
/// All of it is computed in double, and slack covers the rounding. The relative error of N is below 1e-11 (else
/// `distance_only`; edges are formed from one corner, so a distant origin does not matter) and no slope is below 0.05.
/// So the error of a position is below 1e-8 of the size.
struct CaptureVolume {
    bool distance_only = false;
    std::array<V3, 3> corner;   ///< A, B, C [length]
    std::array<V3, 3> rise;     ///< of each corner per height [-]
    V3 axis;                    ///< N^
    std::array<V3, 3> outward;  ///< unit normals in the plane, of the side opposite to each corner
    /// <outward_i, P - A> <= max over the drawn-out corners c of rim_ic + h lean_ic.
    std::array<std::array<double, 3>, 3> rim{}, lean{};
    double low = 0, high = 0;  ///< of h [length]
    double margin = 0;         ///< CaptureLimits::margin
    double slack = 0;          ///< [length]
    double growth = 0;         ///< max(outward, inward) [length]

    /// A proven lower bound on the distance of y to every point that the sub-triangle takes; <= 0 says nothing.
    double clearance(const V3& y) const;
    Box box() const;
};

CaptureVolume capture_volume(const SegmentData& segment, int k, const CaptureLimits& limits);

}  // namespace type21::optimized
