#include "optimized/kernel/contact_point.h"

namespace type21::optimized {

namespace {

V3 mean(const std::array<V3, 4>& v) {
    return (((v[0] + v[1]) + v[2]) + v[3]) * 0.25;
}

struct Weights {
    double a, b, c;
    V3 of(const V3& at_a, const V3& at_b, const V3& at_c) const { return (at_b * b + at_c * c) + at_a * a; }
};

}  // namespace

ContactPoint contact_point(const Tool& tool, const Retained& r, const ToolMotion& pose) {
    const SegmentData s = tool.segment(r.segment);
    const PieceCorners k = piece_corners(s.triangle, r.piece);
    const Landing& l = r.landing;
    const Weights w{1 - l.b - l.c, l.b, l.c};
    const V3 x =
        w.of(s.triangle ? s.node[2] : mean(s.node), s.node[static_cast<size_t>(k.b)], s.node[static_cast<size_t>(k.c)]);
    const double length = norm(l.normal);
    ContactPoint point;
    point.distance = l.lift * length;
    point.normal = rotated(pose.rotation, {l.normal.x / length, l.normal.y / length, l.normal.z / length});
    point.point = from(pose.position) + rotated(pose.rotation, x);
    return point;
}

ContactPoint contact_point_as_built(const Tool& tool, const Retained& r, const Vec3& position, const ToolMotion& pose) {
    SegmentData s = tool.segment(r.segment);
    for (size_t j = 0; j < 4; ++j) {
        s.node[j] = from(pose.position) + rotated(pose.rotation, s.node[j]);
        s.normal[j] = rotated(pose.rotation, s.normal[j]);
    }
    const PieceCorners k = piece_corners(s.triangle, r.piece);
    const Landing& l = r.landing;
    const Weights w{1 - l.b - l.c, l.b, l.c};
    const auto at = [&](const std::array<V3, 4>& v) {
        return w.of(s.triangle ? v[2] : mean(v), v[static_cast<size_t>(k.b)], v[static_cast<size_t>(k.c)]);
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
    const Weights w{1 - l.b - l.c, l.b, l.c};
    const auto at = [&](const std::array<V3, 4>& v) {
        return w.of(s.triangle ? v[2] : mean(v), v[static_cast<size_t>(k.b)], v[static_cast<size_t>(k.c)]);
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
