/// @file D12: the direction of the normal force.
#pragma once

#include "reference/contact/contact_geometry.h"

namespace type21::reference::as_built {

/// As documented: nu is the interpolated normal of the projection.
/// As built: the direction of h = P - X itself, signed by the normal interpolated at (b, c), and delta = |h| with that
/// sign. Close to the surface it is noise, on it the zero vector.
/// @param p        node, in the frame of the triangle [length]
/// @param weights  b and c, unclipped
/// @return X, nu and delta in that frame.  Formulation 12, step 2; Formulation 5, step 2.
/// @manual departure D12
ContactGeometry contact_geometry(const Vec3& p, const SubTriangle<double>& triangle,
                                 const Barycentric<double>& weights);

/// The same formed with the corners brought to global axes, as measured.
/// @return X, nu and delta in the tool frame
/// @manual departure D12
ContactGeometry contact_geometry(const RetainedProjection& retained);

}  // namespace type21::reference::as_built
