#include "optimized/search/capture_volume.h"

namespace type21::optimized {

namespace {

constexpr double coarsest = 1e-11;  ///< relative error of N beyond which the plane is not trusted
constexpr double steepest = 0.05;   ///< least slope of a unit normal that is trusted

/// Corners drawn out (share > 0) from the middle, or in: weights 1 + 2 share, -share, -share.
std::array<V3, 3> drawn_out(const std::array<V3, 3>& v, double share) {
    std::array<V3, 3> out;
    for (size_t i = 0; i < 3; ++i)
        out[i] = v[i] + (v[i] * 2 - v[(i + 1) % 3] - v[(i + 2) % 3]) * share;
    return out;
}

}  // namespace

CaptureVolume capture_volume(const SegmentData& s, int k, const CaptureLimits& limits) {
    CaptureVolume p;
    const SubTriangleCorners of = sub_triangle_corners(s.is_triangle, k);
    const auto mean = [](const std::array<V3, 4>& v) { return ((v[0] + v[1]) + (v[2] + v[3])) * 0.25; };
    p.corner = {s.is_triangle ? s.node[2] : mean(s.node), s.node[static_cast<size_t>(of.b)],
                s.node[static_cast<size_t>(of.c)]};
    const std::array<V3, 3> n{s.is_triangle ? s.normal[2] : mean(s.normal), s.normal[static_cast<size_t>(of.b)],
                              s.normal[static_cast<size_t>(of.c)]};
    p.low = -limits.inward;
    p.high = limits.outward;
    p.growth = std::max(limits.outward, limits.inward);
    p.margin = limits.margin;
    // Edges are formed relative to one corner, so that a distant origin does not matter.
    std::array<V3, 4> local;
    for (size_t j = 0; j < 4; ++j)
        local[j] = s.node[j] - s.node[0];
    const V3 center = s.is_triangle ? local[2] : mean(local);
    const V3 e1 = local[static_cast<size_t>(of.b)] - center, e2 = local[static_cast<size_t>(of.c)] - center;
    double size = 0, far = 0;
    for (size_t j = 0; j < 4; ++j) {
        size = std::max(size, largest(local[j] - center));
        far = std::max(far, largest(s.node[j]));
    }
    p.slack = 1e-7 * (size + p.growth) + 1e-13 * far;
    p.distance_only = true;
    const V3 area = cross(e1, e2);
    const double length = norm(area);
    // Errors, with u = 2^-53 and S the size: of a local corner 2 u S, of their mean 4 u S, of an edge 7 u S, of a
    // component of the cross product 32 u S^2, of N sqrt(3) times that.
    if (!(64 * 0x1p-53 * size * size < coarsest * length)) return p;
    p.axis = area * (1 / length);
    std::array<double, 3> slope{};
    for (size_t i = 0; i < 3; ++i) {
        const double long_normal = norm(n[i]);
        slope[i] = dot(n[i], p.axis);
        if (slope[i] < -1e-6 * long_normal && !limits.lift_leaning) {
            // Rejected off the plane; in the plane there is no lift.
            p.low = p.high = 0;
            slope = {1, 1, 1};
            break;
        }
        if (!(slope[i] > steepest * long_normal)) return p;
    }
    for (size_t i = 0; i < 3; ++i)
        p.rise[i] = n[i] * (1 / slope[i]);
    if (p.low == 0 && p.high == 0) p.rise = {};
    const std::array<V3, 3> wide = drawn_out(p.corner, limits.margin), wide_rise = drawn_out(p.rise, limits.margin);
    for (size_t i = 0; i < 3; ++i) {
        const V3 side = p.corner[(i + 2) % 3] - p.corner[(i + 1) % 3];
        const V3 m = cross(side, p.axis);
        p.outward[i] = m * (1 / norm(m));
        for (size_t c = 0; c < 3; ++c) {
            p.rim[i][c] = dot(p.outward[i], wide[c] - p.corner[0]);
            p.lean[i][c] = dot(p.outward[i], wide_rise[c]);
        }
    }
    p.distance_only = false;
    return p;
}

double CaptureVolume::clearance(const V3& y) const {
    Box plain;
    for (const V3& x : corner)
        plain.extend(x);
    const V3 out{std::max(0.0, std::max(plain.low.x - y.x, y.x - plain.high.x)),
                 std::max(0.0, std::max(plain.low.y - y.y, y.y - plain.high.y)),
                 std::max(0.0, std::max(plain.low.z - y.z, y.z - plain.high.z))};
    double clear = norm(out) - growth;
    if (!distance_only) {
        const V3 from_a = y - corner[0];
        const double h = dot(axis, from_a);
        clear = std::max(clear, std::max(h - high, low - h));
        for (size_t i = 0; i < 3; ++i) {
            // <= 0 in the volume; its gradient is at most sqrt(1 + lean^2).
            double beyond = std::numeric_limits<double>::infinity(), steep = 0;
            for (size_t c = 0; c < 3; ++c) {
                beyond = std::min(beyond, dot(outward[i], from_a) - rim[i][c] - h * lean[i][c]);
                steep = std::max(steep, std::abs(lean[i][c]));
            }
            if (beyond > 0) clear = std::max(clear, beyond / std::sqrt(1 + steep * steep));
        }
    }
    return clear - slack;
}

Box CaptureVolume::box() const {
    Box box;
    for (const V3& x : corner)
        box.extend(x);
    box.grow(growth);
    if (!distance_only) {
        const std::array<V3, 3> wide = drawn_out(corner, margin), wide_rise = drawn_out(rise, margin);
        Box exact;
        for (size_t c = 0; c < 3; ++c) {
            exact.extend(wide[c] + wide_rise[c] * low);
            exact.extend(wide[c] + wide_rise[c] * high);
        }
        box.clip(exact);
    }
    box.grow(slack);
    return box;
}

}  // namespace type21::optimized
