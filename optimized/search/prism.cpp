#include "optimized/search/prism.h"

namespace type21::optimized {

namespace {

constexpr double coarsest = 1e-11;  ///< relative error of N beyond which the plane is not trusted
constexpr double steepest = 0.05;   ///< least slope of a unit normal that is trusted

double least(const std::array<double, 3>& v) {
    return std::min(v[0], std::min(v[1], v[2]));
}
double most(const std::array<double, 3>& v) {
    return std::max(v[0], std::max(v[1], v[2]));
}

/// The smallest m such that <line, x> > bound for every point x that `core` takes with weights >= m, or 1.
/// Those points lie in the hull of Q_j(m) + h (N^ + tau_V), Q_j(m) the corners drawn in to weights m: a linear function
/// is least at one of them.
double margin_beyond(const Prism& core, const V3& line, double bound) {
    double side = std::numeric_limits<double>::infinity();
    for (const V3& tau : core.lean) {
        const double rise = dot(line, core.axis + tau);
        side = std::min(side, std::min(core.low * rise, core.high * rise));
    }
    const std::array<double, 3> at{dot(line, core.corner[0]), dot(line, core.corner[1]), dot(line, core.corner[2])};
    const double middle = (at[0] + at[1] + at[2]) / 3;
    if (!(middle + side > bound)) return 1;
    double margin = 0;
    for (const double value : at) {
        const double missing = bound - (value + side);
        if (missing < 0) continue;
        margin = std::max(margin, missing / (3 * (middle - value)));
    }
    return margin;
}

}  // namespace

Prism prism(const SegmentData& s, int k, const Limits& limits) {
    Prism p;
    const PieceCorners c = piece_corners(s.triangle, k);
    const auto mean = [](const std::array<V3, 4>& v) { return ((v[0] + v[1]) + (v[2] + v[3])) * 0.25; };
    p.corner = {s.triangle ? s.node[2] : mean(s.node), s.node[static_cast<size_t>(c.b)],
                s.node[static_cast<size_t>(c.c)]};
    const std::array<V3, 3> n{s.triangle ? s.normal[2] : mean(s.normal), s.normal[static_cast<size_t>(c.b)],
                              s.normal[static_cast<size_t>(c.c)]};
    p.low = -limits.inward;
    p.high = limits.outward;
    p.growth = std::max(limits.outward, limits.inward);
    const V3 e1 = p.corner[1] - p.corner[0], e2 = p.corner[2] - p.corner[0];
    double size = 0, far = 0;
    for (const V3& x : s.node) {
        size = std::max(size, largest(x - p.corner[0]));
        far = std::max(far, largest(x));
    }
    p.slack = 1e-7 * (size + p.growth) + 1e-13 * far;
    p.grown = true;
    const V3 area = cross(e1, e2);
    const double length = norm(area);
    // The error of a corner is 2^-53 far for the centre: relative to the size it counts like one of the size.
    if (!(48 * 0x1p-53 * (size + far * 0x1p-20) * size < coarsest * length)) return p;
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
    if (p.low < 0 || p.high > 0) {
        const double below = least(slope) - 2 * limits.margin * (most(slope) - least(slope));
        if (!(below > 0.1 * most(slope) * limits.margin)) return p;
        const double spread = limits.margin * most(slope) / below;
        std::array<V3, 3> tau;
        for (size_t i = 0; i < 3; ++i)
            tau[i] = n[i] * (1 / slope[i]) - p.axis;
        for (size_t i = 0; i < 3; ++i)
            p.lean[i] = tau[i] + (tau[i] * 2 - tau[(i + 1) % 3] - tau[(i + 2) % 3]) * spread;
    }
    for (size_t i = 0; i < 3; ++i) {
        const V3& x = p.corner[i];
        p.reached[i] = x + (x * 2 - p.corner[(i + 1) % 3] - p.corner[(i + 2) % 3]) * limits.margin;
    }
    for (size_t i = 0; i < 3; ++i) {
        const V3 side = p.corner[(i + 2) % 3] - p.corner[(i + 1) % 3];
        const V3 m = cross(side, p.axis);
        p.outward[i] = m * (1 / norm(m));
        const auto along = [&](const std::array<V3, 3>& v, const V3& start) {
            return std::array<double, 3>{dot(p.outward[i], v[0] - start), dot(p.outward[i], v[1] - start),
                                         dot(p.outward[i], v[2] - start)};
        };
        p.rim[i] = most(along(p.reached, p.corner[0]));
        p.lean_low[i] = least(along(p.lean, {}));
        p.lean_high[i] = most(along(p.lean, {}));
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
            const double beyond = dot(outward[i], from_a) - rim[i] - std::max(h * lean_high[i], h * lean_low[i]);
            const double steep = std::max(std::abs(lean_low[i]), std::abs(lean_high[i]));
            clear = std::max(clear, beyond > 0 ? beyond / std::sqrt(1 + steep * steep) : beyond);
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
        Box top;
        for (const V3& tau : lean) {
            top.extend((axis + tau) * low);
            top.extend((axis + tau) * high);
        }
        Box exact;
        for (const V3& q : reached) {
            exact.extend(q + top.low);
            exact.extend(q + top.high);
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
        // beyond = min of two linear functions: both must be positive.
        double both = 0;
        for (const double lean : {other.lean_low[i], other.lean_high[i]}) {
            const V3 line = other.outward[i] - other.axis * lean;
            both =
                std::max(both, margin_beyond(core, line, dot(line, a) + other.rim[i] + slack * (1 + std::abs(lean))));
        }
        margin = std::min(margin, both);
    }
    return margin;
}

}  // namespace type21::optimized
