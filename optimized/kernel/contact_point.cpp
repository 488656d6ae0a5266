#include "optimized/kernel/contact_point.h"

namespace type21::optimized {

namespace {

/// Weights of q in (a, b, c) with the area vector n.
PointWeights weights_in(const V3& q, const V3& a, const V3& b, const V3& c, const V3& n) {
    const double square = dot(n, n);
    const V3 qa = a - q, qb = b - q, qc = c - q;
    const double wb = -dot(n, cross(qa, qc)) / square, wc = dot(n, cross(qa, qb)) / square;
    return {1 - wb - wc, wb, wc};
}

/// Steps 1 to 3 in plain double, in space and not in the coordinates of the triangle; those of the projection where
/// this is not a number.
PointWeights weights_step_by_step(const SegmentData& s, const Retained& r, const V3& y) {
    const SubTriangleCorners k = sub_triangle_corners(s.is_triangle, r.id.triangle());
    const auto corners = [&](const std::array<V3, 4>& v) {
        return std::array<V3, 3>{s.is_triangle ? v[2] : mean_of(v), v[static_cast<size_t>(k.b)],
                                 v[static_cast<size_t>(k.c)]};
    };
    const std::array<V3, 3> x = corners(s.node), n = corners(s.normal);
    const V3 area = cross(x[1] - x[0], x[2] - x[0]);
    const double height = dot(y - x[0], area);
    std::array<V3, 3> lifted = x;
    if (height != 0) {
        std::array<double, 3> slope{dot(n[0], area), dot(n[1], area), dot(n[2], area)};
        const bool leaning = !(slope[0] > 0 && slope[1] > 0 && slope[2] > 0);
        for (size_t i = 0; i < 3; ++i) {
            if (leaning) slope[i] = std::max(slope[i], leaning_guard);  // D35
            lifted[i] = x[i] + n[i] * (height / slope[i]);
        }
    }
    const V3 turned = cross(lifted[1] - lifted[0], lifted[2] - lifted[0]);
    const PointWeights first = weights_in(y, lifted[0], lifted[1], lifted[2], turned);
    const V3 normal = n[0] * first.a + n[1] * first.b + n[2] * first.c;
    const V3 q = y - normal * (height / dot(normal, area));
    const PointWeights w = weights_in(q, x[0], x[1], x[2], area);
    if (std::isfinite(w.b) && std::isfinite(w.c)) return w;
    return {1 - r.projection.b - r.projection.c, r.projection.b, r.projection.c};
}

}  // namespace

ContactPoint contact_point_as_built(const Tool& tool, const Retained& r, const V3& y, const Vec3& position,
                                    const ToolMotion& pose) {
    SegmentData s = tool.segment(r.id.segment());
    const PointWeights w = weights_step_by_step(s, r, y);
    for (size_t j = 0; j < 4; ++j) {
        s.node[j] = from(pose.position) + rotated(pose.rotation, s.node[j]);
        s.normal[j] = rotated(pose.rotation, s.normal[j]);
    }
    const SubTriangleCorners k = sub_triangle_corners(s.is_triangle, r.id.triangle());
    const auto at = [&](const std::array<V3, 4>& v) {
        return w.of(s.is_triangle ? v[2] : mean_of(v), v[static_cast<size_t>(k.b)], v[static_cast<size_t>(k.c)]);
    };
    ContactPoint point;
    point.point = at(s.node);
    const V3 h = from(position) - point.point;
    const double side = dot(h, at(s.normal)) < 0 ? -1 : 1;
    const double length = norm(h);
    point.distance = side * length;
    if (length > 0) point.normal = h * (side / length);
    return point;
}

ContactPoint contact_point_at_start(const Tool& tool, const Retained& r, const V3& y) {
    const SegmentData s = tool.segment(r.id.segment());
    const SubTriangleCorners k = sub_triangle_corners(s.is_triangle, r.id.triangle());
    const ProjectionResult& l = r.projection;
    const PointWeights w{1 - l.b - l.c, l.b, l.c};
    const auto at = [&](const std::array<V3, 4>& v) {
        return w.of(s.is_triangle ? v[2] : mean_of(v), v[static_cast<size_t>(k.b)], v[static_cast<size_t>(k.c)]);
    };
    ContactPoint point;
    point.point = at(s.node);
    const V3 normal = at(s.normal);
    const double length = norm(normal);
    if (length > 0) point.normal = {normal.x / length, normal.y / length, normal.z / length};
    point.distance = dot(y - point.point, point.normal);
    return point;
}

}  // namespace type21::optimized
