/// @file Rotations as unit quaternions, so that a tool stays rigid over any number of steps.
#pragma once

#include <cmath>

#include "reference/contract/vector.h"

namespace type21 {

using Rotation = Eigen::Quaterniond;

/// exp([w]) for the rotation vector w = angle * axis [rad]. Exact for any angle, smooth at zero.
inline Rotation exponential(const Vec3& w) {
    const double angle = w.norm();
    const double half = 0.5 * angle;
    // sin(x)/x by its series where x^2 is below the rounding of 1.
    const double ratio = half < 1e-4 ? 0.5 * (1.0 - half * half / 6.0) : std::sin(half) / angle;
    return {std::cos(half), ratio * w.x(), ratio * w.y(), ratio * w.z()};
}

/// R_{n+1} = exp(dt [omega]) R_n, renormalised, since rounding changes the length of the quaternion.
/// @param angular_velocity  omega [1/time]
/// @param step              dt [time].  Formulation 11, step 5.
inline Rotation turned(const Rotation& rotation, const Vec3& angular_velocity, double step) {
    return (exponential(angular_velocity * step) * rotation).normalized();
}

}  // namespace type21
