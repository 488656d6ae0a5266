/// @file Where the retained impact lies (Formulation 5, steps 1 to 3).
#pragma once

#include "optimized/projection/decide.h"
#include "optimized/projection/project_double.h"
#include "optimized/search/tool.h"
#include "reference/contract/decision.h"
#include "reference/contract/motion.h"

namespace type21::optimized {

/// In global axes.
struct ContactPoint {
    V3 point;             ///< X [length]
    V3 normal;            ///< nu, outward [-]
    double distance = 0;  ///< delta along nu [length]
};

inline V3 rotated(const Mat3& r, const V3& v) {
    return {r(0, 0) * v.x + r(0, 1) * v.y + r(0, 2) * v.z, r(1, 0) * v.x + r(1, 1) * v.y + r(1, 2) * v.z,
            r(2, 0) * v.x + r(2, 1) * v.y + r(2, 2) * v.z};
}

inline V3 mean_of(const std::array<V3, 4>& v) {
    return (((v[0] + v[1]) + v[2]) + v[3]) * 0.25;
}

/// Weights (a, b, c) of a point.
struct PointWeights {
    double a, b, c;
    V3 of(const V3& at_a, const V3& at_b, const V3& at_c) const { return (at_b * b + at_c * c) + at_a * a; }
};

/// X = aA + bB + cC, nu = n / |n|, delta = lift |n|.
inline ContactPoint contact_point(const Tool& tool, const Retained& r, const ToolMotion& pose) {
    const ProjectionResult& l = r.projection;
    const V3 x = point_at(tool.segment(r.id.segment()), r.id.triangle(), l.b, l.c);
    const double length = norm(l.normal);
    ContactPoint point;
    point.distance = l.lift * length;
    point.normal = rotated(pose.rotation, {l.normal.x / length, l.normal.y / length, l.normal.z / length});
    point.point = from(pose.position) + rotated(pose.rotation, x);
    return point;
}

/// D12: the direction of h = P - X, with the sign of the normal interpolated at (b, c); zero where h is. As measured,
/// it is formed with the corners brought to global axes, and with weights from Formulation 3, steps 1 to 3, step by
/// step in space: near the surface the direction is the noise of exactly these operations.
/// @manual departure D12
ContactPoint contact_point_as_built(const Tool& tool, const Retained& retained, const V3& y, const Vec3& position,
                                    const ToolMotion& pose);

/// D31, at time 0: the distance along the normal interpolated at (b, c), P - X with it. In the tool frame.
/// @manual departure D31
ContactPoint contact_point_at_start(const Tool& tool, const Retained& retained, const V3& y);

}  // namespace type21::optimized
