// The bounds below are first-order error analyses with every constant rounded up; e is the largest relative error of
// one operation, 2^-53 in double and 2^-100 in TwoDoubles, |v| is the maximum norm. Each bound was derived by hand from
// the line it follows; second-order terms are covered because the filter gives up (unsure) where a relative error
// exceeds 1e-4. Underflow is covered because every bound is at least e times the product of the magnitudes that enter,
// and lengths outside Range are not filtered at all.
#include "optimized/projection/filter.h"

namespace type21::optimized {

namespace {

/// Magnitudes whose products of up to four lengths and two normals stay far from the ends of double's range, the low
/// parts of TwoDoubles too.
template <class Real>
struct Range;
template <>
struct Range<double> {
    static constexpr double smallest_length = 1e-60, largest_length = 1e60, smallest_normal = 1e-30,
                            largest_normal = 1e30;
};
template <bool fused>
struct Range<TwoDoublesOf<fused>> {
    static constexpr double smallest_length = 1e-30, largest_length = 1e30, smallest_normal = 1e-10,
                            largest_normal = 1e10;
};
constexpr double too_coarse = 1e-4;
/// Second-order terms of all bounds: each relative error is below 1e-4, fewer than 50 of them multiply.
constexpr double second_order = 1.01;

template <class Real>
TYPE21_INLINE Real clip(const Real& w) {
    if (leading(w) < 0) return Real(0);
    return w > Real(1) ? Real(1) : w;
}

TwoDoubles two_doubles(double v) {
    return v;
}
template <bool fused>
TwoDoubles two_doubles(const TwoDoublesOf<fused>& v) {
    return {v.high, v.low};
}

enum class Answer { no, yes, unsure };

/// Is value > 0, when it is known to within bound? NaN is unsure.
Answer positive(double value, double bound) {
    if (value > bound) return Answer::yes;
    if (value < -bound) return Answer::no;
    return Answer::unsure;
}

/// Are the weights (scaled by total > 0) within the limits, each test known to within bound?
template <class Real>
TYPE21_INLINE Answer inside(const Real& b, const Real& c, const Real& total, double bound,
                            const ProjectionLimits& rules) {
    const double over_b = leading(b - Real(rules.low) * total);
    const double over_c = leading(c - Real(rules.low) * total);
    const double under = leading(Real(rules.high) * total - (b + c));
    const double least = std::min(over_b, std::min(over_c, under));
    return positive(least, bound);
}

/// @param precise  filled with kappa as it was computed; nullptr: not needed
template <class Real>
TYPE21_INLINE FilterResult filter_in(const V3& p, const SegmentData& segment, const LocalSegmentIn<Real>& local, int k,
                                     const ContactReach& reach, const ProjectionLimits& rules,
                                     KappaDoubleDouble* precise) {
    constexpr double e = Rounding<Real>::unit;
    const Real one(1);
    FilterResult result;
    const auto settle = [&](Answer answer) {
        if (answer == Answer::no) result.verdict = Verdict::rejected;
        return answer != Answer::yes;
    };
    const SubTriangleCorners corner = sub_triangle_corners(segment.is_triangle, k);
    const Triple<Real> nb = widened<Real>(segment.normal[static_cast<size_t>(corner.b)]);
    const Triple<Real> nc = widened<Real>(segment.normal[static_cast<size_t>(corner.c)]);
    const Triple<Real>& na = local.center_normal;
    const double nm = local.normal_size;

    // S bounds |P - o| and |x_j - o|. Each of e1, e2, u is within 5 e S of exact: corner differences e S, the centre
    // 2 e S (three of these, two additions of at most 2 S and 3 S, then a quarter), their difference 1.75 e S. All are
    // at most 1.75 S.
    const Triple<Real> from_origin = widened<Real>(p) - widened<Real>(local.origin);
    const double s = std::max(local.extent, largest(from_origin));
    if (!(s >= Range<Real>::smallest_length && s <= Range<Real>::largest_length && nm >= Range<Real>::smallest_normal &&
          nm <= Range<Real>::largest_normal))
        return result;
    const Triple<Real> e1 = local.corner[static_cast<size_t>(corner.b)] - local.center;
    const Triple<Real> e2 = local.corner[static_cast<size_t>(corner.c)] - local.center;
    const Triple<Real> u = from_origin - local.center;
    const double edge = std::max(largest(e1), largest(e2));

    // N within 48 e S^2: 2 (2 x 5 e S x 1.75 S) + 4 e (1.75 S)^2. eta is its relative error.
    const Triple<Real> area = cross(e1, e2);
    const double area_size = largest(area);
    const double eta = 48 * e * s * s / area_size * second_order;
    if (!(eta < too_coarse)) return result;  // slivers and N = 0

    // A component of N is at most 2 S^2 of a triangle, whose A is o, and at most 1.875 S^2 of a quarter of a quad: eta
    // is at least 24 e. So the constants from here on, 5.2, 6.6, 3.7 and the others, hold the few e of each operation,
    // too. D2 = |N|^2 within 3.5 eta + 4 e of itself; g1, g2 within 5.2 eta Gm, Gm = 2 |e| |N| / D2 their largest size.
    const Real d2 = dot(area, area);
    const Real of_square = one / d2;
    const Triple<Real> g1 = cross(e2, area) * of_square;
    const Triple<Real> g2 = cross(area, e1) * of_square;
    const double gm = 2 * edge * area_size / leading(d2) * second_order;
    const double aspect = gm * s;

    // H within 6.6 eta |N| S, slopes within 3.7 eta nm |N|.
    const Real height = dot(u, area);
    const double height_bound = 6.6 * eta * area_size * s * second_order;
    const Real slope_a = dot(na, area), slope_b = dot(nb, area), slope_c = dot(nc, area);
    const double slope_bound = 3.7 * eta * nm * area_size * second_order;
    const double least_slope = std::min(leading(slope_a), std::min(leading(slope_b), leading(slope_c)));
    const Answer upright = positive(least_slope, slope_bound);
    const Answer off_plane = std::abs(leading(height)) > height_bound ? Answer::yes : Answer::unsure;
    if (upright != Answer::yes) {
        // Leaning rejects only off the plane, and not at all with D35.
        if (upright == Answer::no && off_plane == Answer::yes && !rules.lift_leaning)
            result.verdict = Verdict::rejected;
        return result;
    }

    // Step 1 in the coordinates of the triangle, A = (0, 0), B = (1, 0), C = (0, 1): V' - P = V + r_V (x_V, y_V) - (p,
    // q), r_V = H / <n_V, N>. p, q within 29 eta Gm S; x_V, y_V within 17 eta nm Gm and at most 3 nm Gm.
    const Real px = dot(u, g1), py = dot(u, g2);
    const Real xa = dot(na, g1), ya = dot(na, g2);
    const Real xb = dot(nb, g1), yb = dot(nb, g2);
    const Real xc = dot(nc, g1), yc = dot(nc, g2);
    const Real ra = height / slope_a, rb = height / slope_b, rc = height / slope_c;
    const Real ax = ra * xa - px, ay = ra * ya - py;
    const Real bx = (one + rb * xb) - px, by = rb * yb - py;
    const Real cx = rc * xc - px, cy = (one + rc * yc) - py;
    // r_V within eta w (6.6 S / nm + 3.7 |r|), w = nm |N| / (smallest slope); each coordinate then within
    // eta (30 + 21 w)(Gm S + Gm nm |r|).
    const double w = nm * area_size / (least_slope - slope_bound);
    const double r_size = std::max(std::abs(leading(ra)), std::max(std::abs(leading(rb)), std::abs(leading(rc))));
    const double coordinate_bound = eta * (30 + 21 * w) * (aspect + gm * nm * r_size) * second_order;
    const double z = std::max(largest(Triple<Real>{ax, bx, cx}), largest(Triple<Real>{ay, by, cy}));
    if (!(coordinate_bound < too_coarse * z && eta * w < too_coarse)) return result;

    // Step 2: weights times W = sum of them; each within 4.1 z d + 8 e z^2, each test within six of these.
    const Real wa = bx * cy - by * cx;
    const Real wb = cx * ay - cy * ax;
    const Real wc = ax * by - ay * bx;
    const Real total = wa + wb + wc;
    const double weight_error = (4.1 * z * coordinate_bound + 8 * e * z * z) * second_order;
    if (settle(positive(leading(total), 6 * weight_error))) return result;
    if (settle(inside(wb, wc, total, 6 * weight_error, rules))) return result;

    // Step 3: n = sum w n_V, slope = <n, N> = sum w <n_V, N>.
    const Real inverse = one / total;
    const Real b1 = wb * inverse, c1 = wc * inverse, a1 = wa * inverse;
    const double db = 4.5 * weight_error / (leading(total) - 3 * weight_error) + 4 * e;
    if (!(db < too_coarse)) return result;
    const double slope_size = largest(Triple<Real>{slope_a, slope_b, slope_c});
    const Real slope = a1 * slope_a + b1 * slope_b + c1 * slope_c;
    const double interpolated_bound = (3.1 * db * slope_size + 15 * eta * nm * area_size) * second_order;
    if (settle(positive(leading(slope), interpolated_bound))) return result;
    const Real lift = height / slope;
    const Real nx = a1 * xa + b1 * xb + c1 * xc;
    const Real ny = a1 * ya + b1 * yb + c1 * yc;
    const Real shift_x = nx * lift, shift_y = ny * lift;
    const Real b = px - shift_x, c = py - shift_y;
    const double lift_size = std::abs(leading(lift));
    const double lift_bound =
        (height_bound + lift_size * interpolated_bound) / (leading(slope) - interpolated_bound) + e * lift_size;
    const double n_bound = nm * gm * (9.1 * db + 59 * eta);
    const double n_size = std::max(std::abs(leading(nx)), std::abs(leading(ny)));
    const double p_size = std::max(std::abs(leading(px)), std::abs(leading(py)));
    const double q_bound = (29 * eta * aspect + n_size * lift_bound + (lift_size + lift_bound) * n_bound +
                            3 * e * (n_size * lift_size + p_size)) *
                           second_order;
    if (!(q_bound < too_coarse)) return result;
    if (settle(inside(b, c, one, 2.1 * q_bound + 8 * e, rules))) return result;

    // Step 4: (a, b, c) clipped and rescaled is within 6 q + 4 e; the point then within that times 2 |e| and rounding.
    const Real a = one - b - c;
    const Real ac = clip(a), bc = clip(b), cc = clip(c);
    const Real clipped = one / (ac + bc + cc);
    const Triple<Real> offset = u - (e1 * (bc * clipped) + e2 * (cc * clipped));
    const double offset_bound = ((2 * edge) * (6 * q_bound + 5 * e) + 30 * e * s) * second_order;
    const Real distance2 = dot(offset, offset);
    const double sum = std::abs(leading(offset.x)) + std::abs(leading(offset.y)) + std::abs(leading(offset.z));
    const double distance2_bound =
        (2 * offset_bound * sum + 3 * offset_bound * offset_bound + 6 * e * leading(distance2)) * second_order;
    // Step 5; strict comparisons with the squares, which round once.
    const auto nearer = [&](double limit_distance) {
        const Real limit = Rounding<Real>::exact_product(limit_distance, limit_distance);
        return positive(leading(limit - distance2), distance2_bound + 3 * e * leading(limit));
    };
    // The side of the clipped point is the side of P: it lies in the plane, <P - point, N> = H.
    const Answer front = off_plane == Answer::yes ? (leading(height) > 0 ? Answer::yes : Answer::no) : Answer::unsure;
    const Answer within_gap = front == Answer::no ? Answer::no : nearer(reach.gap);
    const Answer within_depth = front == Answer::yes ? Answer::no : nearer(reach.depth);
    Kind kind = Kind::none;
    if (front == Answer::unsure) {
        // Nearer than both limits it is contact on either side. Anything else depends on the side.
        if (within_gap != Answer::yes || within_depth != Answer::yes) return result;
        kind = Kind::contact;
    } else {
        const Answer touching = front == Answer::yes ? within_gap : within_depth;
        if (touching == Answer::unsure) return result;
        if (touching == Answer::yes) {
            kind = Kind::contact;
        } else if (front == Answer::yes && reach.proximity > 0) {
            const Answer near = nearer(reach.proximity);
            if (near == Answer::unsure) return result;
            if (near == Answer::yes) kind = Kind::proximity;
        }
    }

    ProjectionResult& projection = result.projection;
    projection.kind = kind;
    projection.side = front == Answer::yes ? 1 : (front == Answer::no ? -1 : 0);
    const Real third = Rounding<Real>::third();
    const Real kappa = magnitude(third - b) + magnitude(third - c) + magnitude(third + third - b - c);
    const auto rounded = [](const Triple<Real>& v) { return V3{leading(v.x), leading(v.y), leading(v.z)}; };
    projection.b = leading(b);
    projection.c = leading(c);
    projection.kappa = leading(kappa);
    projection.normal = rounded(na * a1 + nb * b1 + nc * c1);
    projection.lift = leading(lift);
    if (kind == Kind::none)
        projection.height =
            std::copysign((std::abs(leading(height)) + height_bound) / std::sqrt(leading(d2)) * (1 + 2 * too_coarse),
                          leading(height));
    projection.least_w = std::min(leading(a1), std::min(leading(b1), leading(c1))) - db;
    projection.weight_bound = q_bound + 2 * 0x1p-53;
    projection.kappa_bound = 4.1 * q_bound + 12 * 0x1p-53;
    if (precise != nullptr) *precise = {two_doubles(kappa), 4.1 * q_bound + 12 * e};
    result.verdict = kind == Kind::none ? Verdict::too_far : Verdict::taken;
    return result;
}

}  // namespace

FilterResult filter(const V3& p, const SegmentData& segment, const LocalSegment& local, int k,
                    const ContactReach& reach, const ProjectionLimits& rules) {
    return filter_in<double>(p, segment, local, k, reach, rules, nullptr);
}

// The bounds of N and of the slopes are those of filter_in, with S = extent: the node has no part in them.
bool slope_is_not_zero(const SegmentData& segment, const LocalSegment& local, int k, int corner) {
    constexpr double e = Rounding<double>::unit;
    const double s = local.extent, nm = local.normal_size;
    if (!(s >= Range<double>::smallest_length && s <= Range<double>::largest_length &&
          nm >= Range<double>::smallest_normal && nm <= Range<double>::largest_normal))
        return false;
    const SubTriangleCorners corners = sub_triangle_corners(segment.is_triangle, k);
    const V3 area = cross(local.corner[static_cast<size_t>(corners.b)] - local.center,
                          local.corner[static_cast<size_t>(corners.c)] - local.center);
    const double area_size = largest(area);
    const double eta = 48 * e * s * s / area_size * second_order;
    if (!(eta < too_coarse)) return false;
    const V3& n =
        corner == 0 ? local.center_normal : segment.normal[static_cast<size_t>(corner == 1 ? corners.b : corners.c)];
    return std::abs(dot(n, area)) > 3.7 * eta * nm * area_size * second_order;
}

namespace {

template <bool fused>
TYPE21_INLINE FilterResult filter_double_double_in(const V3& p, const SegmentData& segment, int k,
                                                   const ContactReach& reach, const ProjectionLimits& rules,
                                                   KappaDoubleDouble& kappa) {
    using Real = TwoDoublesOf<fused>;
    return filter_in<Real>(p, segment, local_segment_in<Real>(segment), k, reach, rules, &kappa);
}

TYPE21_FMA FilterResult filter_double_double_fma(const V3& p, const SegmentData& segment, int k,
                                                 const ContactReach& reach, const ProjectionLimits& rules,
                                                 KappaDoubleDouble& kappa) {
    return filter_double_double_in<true>(p, segment, k, reach, rules, kappa);
}

}  // namespace

FilterResult filter_double_double(const V3& p, const SegmentData& segment, int k, const ContactReach& reach,
                                  const ProjectionLimits& rules, KappaDoubleDouble& kappa) {
    return has_fma() ? filter_double_double_fma(p, segment, k, reach, rules, kappa)
                     : filter_double_double_in<false>(p, segment, k, reach, rules, kappa);
}

}  // namespace type21::optimized
