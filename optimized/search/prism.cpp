#include "optimized/search/prism.h"

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

/// The smallest m such that <line, x> > bound for every point x of `core` with weights >= m, or 1. Those points lie in
/// the hull of the corners drawn in to weights m, at the lowest and at the greatest height: a linear function is least
/// at one of these six.
double margin_beyond(const Prism& core, const V3& line, double bound) {
    double margin = 0;
    for (const double h : {core.low, core.high}) {
        std::array<double, 3> at;
        for (size_t i = 0; i < 3; ++i)
            at[i] = dot(line, core.corner[i]) + h * dot(line, core.rise[i]);
        const double middle = (at[0] + at[1] + at[2]) / 3;
        if (!(middle > bound)) return 1;
        for (const double value : at) {
            // Drawn in to m, the corner has value + 3 m (middle - value).
            if (value <= bound) margin = std::max(margin, (bound - value) / (3 * (middle - value)));
        }
    }
    return margin;
}

}  // namespace

Prism prism(const SegmentData& s, int k, const Limits& limits) {
    Prism p;
    const PieceCorners of = piece_corners(s.triangle, k);
    const auto mean = [](const std::array<V3, 4>& v) { return ((v[0] + v[1]) + (v[2] + v[3])) * 0.25; };
    p.corner = {s.triangle ? s.node[2] : mean(s.node), s.node[static_cast<size_t>(of.b)],
                s.node[static_cast<size_t>(of.c)]};
    const std::array<V3, 3> n{s.triangle ? s.normal[2] : mean(s.normal), s.normal[static_cast<size_t>(of.b)],
                              s.normal[static_cast<size_t>(of.c)]};
    p.low = -limits.inward;
    p.high = limits.outward;
    p.growth = std::max(limits.outward, limits.inward);
    p.margin = limits.margin;
    // Edges from coordinates relative to one corner: a distant origin does not matter to them.
    std::array<V3, 4> local;
    for (size_t j = 0; j < 4; ++j)
        local[j] = s.node[j] - s.node[0];
    const V3 center = s.triangle ? local[2] : mean(local);
    const V3 e1 = local[static_cast<size_t>(of.b)] - center, e2 = local[static_cast<size_t>(of.c)] - center;
    double size = 0, far = 0;
    for (size_t j = 0; j < 4; ++j) {
        size = std::max(size, largest(local[j] - center));
        far = std::max(far, largest(s.node[j]));
    }
    p.slack = 1e-7 * (size + p.growth) + 1e-13 * far;
    p.grown = true;
    const V3 area = cross(e1, e2);
    const double length = norm(area);
    // With u = 2^-53 and S the size: a local corner is off by 2 u S, their mean by 4 u S, an edge by 7 u S, a component
    // of the cross product by 32 u S^2, and N by sqrt(3) times that.
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
    p.grown = false;
    return p;
}

double Prism::clearance(const V3& y) const {
    Box plain;
    for (const V3& x : corner)
        plain.extend(x);
    const V3 out{std::max(0.0, std::max(plain.low.x - y.x, y.x - plain.high.x)),
                 std::max(0.0, std::max(plain.low.y - y.y, y.y - plain.high.y)),
                 std::max(0.0, std::max(plain.low.z - y.z, y.z - plain.high.z))};
    double clear = norm(out) - growth;
    if (!grown) {
        const V3 from_a = y - corner[0];
        const double h = dot(axis, from_a);
        clear = std::max(clear, std::max(h - high, low - h));
        for (size_t i = 0; i < 3; ++i) {
            // <= 0 in the region; it changes by at most sqrt(1 + lean^2) per way of y.
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

Box Prism::box() const {
    Box box;
    for (const V3& x : corner)
        box.extend(x);
    box.grow(growth);
    if (!grown) {
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

double margin_apart(const Prism& core, const Prism& other) {
    if (core.grown) return 1;
    const double slack = core.slack + other.slack;
    if (other.grown) {
        // Apart where a side of the grown box is.
        Box box = other.box();
        const std::array<V3, 3> unit{V3{1, 0, 0}, V3{0, 1, 0}, V3{0, 0, 1}};
        double margin = 1;
        for (int i = 0; i < 3; ++i) {
            margin = std::min(margin, margin_beyond(core, unit[static_cast<size_t>(i)], box.high[i] + slack));
            margin = std::min(margin, margin_beyond(core, unit[static_cast<size_t>(i)] * -1, slack - box.low[i]));
        }
        return margin;
    }
    double margin = 1;
    const V3& a = other.corner[0];
    margin = std::min(margin, margin_beyond(core, other.axis, dot(other.axis, a) + other.high + slack));
    margin = std::min(margin, margin_beyond(core, other.axis * -1, -dot(other.axis, a) - other.low + slack));
    for (size_t i = 0; i < 3; ++i) {
        // Beyond side i are the points that are beyond all three of its linear bounds.
        double beyond_all = 0;
        for (size_t c = 0; c < 3; ++c) {
            const V3 line = other.outward[i] - other.axis * other.lean[i][c];
            const double bound = dot(line, a) + other.rim[i][c] + slack * (1 + std::abs(other.lean[i][c]));
            beyond_all = std::max(beyond_all, margin_beyond(core, line, bound));
        }
        margin = std::min(margin, beyond_all);
    }
    return margin;
}

}  // namespace type21::optimized
