#include "optimized/kernel/contact_point.h"

namespace type21::optimized {

ContactPoint contact_point_as_built(const Tool& tool, const Retained& r, const Vec3& position, const ToolMotion& pose) {
    SegmentData s = tool.segment(r.segment);
    for (size_t j = 0; j < 4; ++j) {
        s.node[j] = from(pose.position) + rotated(pose.rotation, s.node[j]);
        s.normal[j] = rotated(pose.rotation, s.normal[j]);
    }
    const PieceCorners k = piece_corners(s.triangle, r.piece);
    const Landing& l = r.landing;
    const PointWeights w{1 - l.b - l.c, l.b, l.c};
    const auto at = [&](const std::array<V3, 4>& v) {
        return w.of(s.triangle ? v[2] : mean_of(v), v[static_cast<size_t>(k.b)], v[static_cast<size_t>(k.c)]);
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
    const SegmentData s = tool.segment(r.segment);
    const PieceCorners k = piece_corners(s.triangle, r.piece);
    const Landing& l = r.landing;
    const PointWeights w{1 - l.b - l.c, l.b, l.c};
    const auto at = [&](const std::array<V3, 4>& v) {
        return w.of(s.triangle ? v[2] : mean_of(v), v[static_cast<size_t>(k.b)], v[static_cast<size_t>(k.c)]);
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
