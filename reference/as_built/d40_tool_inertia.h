/// @file D40: the inertia on which the rotation of a tool is damped.
#pragma once

#include "reference/contract/rigid_body.h"

namespace type21::reference::as_built {

/// As documented: the inertia about the axis of the rotation.
/// As built: the smallest principal inertia, for every axis.
/// @return I [mass length^2].  Formulation 12, step 2; Formulation 9, step 16.
/// @manual departure D40
inline double damped_inertia(const RigidBody& tool, const Mat3& /*rotation*/, const Vec3& /*spin*/) {
    return smallest_inertia(tool.inertia);
}

}  // namespace type21::reference::as_built
