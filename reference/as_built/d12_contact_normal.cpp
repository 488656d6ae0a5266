#include "reference/as_built/d12_contact_normal.h"

namespace type21::reference::as_built {

namespace {

/// The segment where the tool is now.
SegmentShape<double> in_global_axes(SegmentShape<double> segment, const ToolMotion& pose) {
    for (Vec3& node : segment.node)
        node = pose.position + pose.rotation * node;
    for (Vec3& normal : segment.normal)
        normal = pose.rotation * normal;
    return segment;
}

}  // namespace

ContactGeometry contact_geometry(const Vec3& p, const SubTriangle<double>& triangle,
                                 const Barycentric<double>& weights) {
    ContactGeometry geometry;
    geometry.point = interpolated(triangle.a, triangle.b, triangle.c, weights);
    const Vec3 normal = interpolated(triangle.normal_a, triangle.normal_b, triangle.normal_c, weights);
    const Vec3 h = p - geometry.point;
    const double sign = h.dot(normal) < 0 ? -1.0 : 1.0;
    const double length = h.norm();
    geometry.distance = sign * length;
    if (length > 0) geometry.normal = h * (sign / length);
    return geometry;
}

ContactGeometry contact_geometry(const RetainedProjection& retained) {
    const ToolMotion& pose = retained.pose;
    const auto triangle = sub_triangle(in_global_axes(retained.segment, pose), retained.triangle);
    ContactGeometry geometry = contact_geometry(retained.position, triangle, retained.projection.weights);
    geometry.normal = pose.rotation.transpose() * geometry.normal;
    geometry.point = pose.rotation.transpose() * (geometry.point - pose.position);
    return geometry;
}

}  // namespace type21::reference::as_built
