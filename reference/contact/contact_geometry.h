/// @file Where the retained impact lies and how deep (formulation section 5).
#pragma once

#include "reference/contact/retained_impact.h"

namespace type21::reference {

/// In the tool frame.
struct ContactGeometry {
    Vec3 point = Vec3::Zero();   ///< X = aA + bB + cC, weights unclipped [length]
    Vec3 normal = Vec3::Zero();  ///< nu, outward always [-]
    double distance = 0;         ///< delta = H |n| / <n, N>, along nu, negative behind [length]
};

/// The page: the normal is the interpolated n of the projection. Since X - P is parallel to n this is well conditioned
/// at any distance, and the normal turns continuously along the tool.
ContactGeometry contact_geometry(const SubTriangle<double>& triangle, const Projection<double>& projection);

/// D12: the direction of h = P - X itself, signed by the normal interpolated at (b, c); noise close to the surface,
/// zero on it. Formed, as measured, with the corners brought to global axes: `triangle` and p are global here.
/// @manual departure D12
ContactGeometry contact_geometry_as_built(const Vec3& p, const SubTriangle<double>& triangle,
                                          const Barycentric<double>& weights);

/// p_g = max(0, g - delta), and 0 where g - delta is within 16 ulp of the node's largest tool-frame coordinate: a touch
/// within rounding is no impact, else the first-impact offset would hang on the last bit.
/// @param gap       g [length]
/// @param distance  delta [length]
/// @param y         the node in the tool frame [length]
double geometric_penetration(double gap, double distance, const Vec3& y);

}  // namespace type21::reference
