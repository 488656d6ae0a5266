#include "reference/as_built/d31_first_impact.h"

namespace type21::reference::as_built {

namespace {

ContactReach<double> reach_of_own_gap(const ContactReach<double>& reach, double gap) {
    return {gap, reach.depth, 0.0};
}

ContactGeometry first_geometry(const RetainedProjection& retained) {
    const auto t = sub_triangle(retained.segment, retained.triangle);
    const auto& weights = retained.projection.weights;
    ContactGeometry geometry;
    geometry.point = interpolated(t.a, t.b, t.c, weights);
    geometry.normal = interpolated(t.normal_a, t.normal_b, t.normal_c, weights).normalized();
    geometry.distance = (retained.y - geometry.point).dot(geometry.normal);
    return geometry;
}

}  // namespace

ImpactReading first_impact(const ImpactReading& impact) {
    ImpactReading first;
    first.limits = impact.limits;
    first.limits.low = -0.05;
    first.limits.high = 1.05;
    first.reach = reach_of_own_gap;
    first.geometry = first_geometry;
    return first;
}

}  // namespace type21::reference::as_built
