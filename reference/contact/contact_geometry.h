/// @file Where the retained impact lies and how deep (chapter 5 of the formulation).
#pragma once

#include "reference/contact/retained_impact.h"
#include "reference/contract/motion.h"

namespace type21::reference {

/// In the tool frame.
struct ContactGeometry {
    Vec3 point = Vec3::Zero();   ///< X = aA + bB + cC, weights unclipped [length]
    Vec3 normal = Vec3::Zero();  ///< nu, outward always [-]
    double distance = 0;         ///< delta = H |n| / <n, N>, along nu, negative behind [length]
};

/// The retained projection of a node, with all that a geometry may be formed from.
struct RetainedProjection {
    const SegmentShape<double>& segment;  ///< in the tool frame
    int triangle;                         ///< retained sub-triangle, 1..4
    const Projection<double>& projection;
    Vec3 y;                  ///< the node in the tool frame [length]
    Vec3 position;           ///< the node in global axes [length]
    const ToolMotion& pose;  ///< of the tool
};

/// The normal is the interpolated n of the projection. Since X - P is parallel to n this is well conditioned at any
/// distance, and the normal turns continuously along the tool.
/// @param triangle    retained sub-triangle, tool frame
/// @param projection  of the node on it, accepted: slope > 0
/// @return X, nu and delta in the tool frame.  Formulation 5, step 1 to step 3; as built: D12, D31.
ContactGeometry contact_geometry(const SubTriangle<double>& triangle, const Projection<double>& projection);
ContactGeometry contact_geometry(const RetainedProjection& retained);

/// (1 - b - c) A + b B + c C
/// @return of the dimension of the corners.  Formulation 5, step 1.
Vec3 interpolated(const Vec3& a, const Vec3& b, const Vec3& c, const Barycentric<double>& weights);

/// p_g = max(0, g - delta), and 0 where g - delta is within 16 ulp of the node's largest tool-frame coordinate: a touch
/// within rounding is no impact, else the first-impact offset would depend on the last bit.
/// @param gap       g [length]
/// @param distance  delta [length]
/// @param y         the node in the tool frame [length]
/// @return p_g [length], >= 0.  Formulation 5, step 4.
double geometric_penetration(double gap, double distance, const Vec3& y);

}  // namespace type21::reference
