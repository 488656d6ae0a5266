#include "optimized/search/weight_lipschitz.h"

#include <algorithm>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "optimized/projection/a_priori_bounds.h"
#include "optimized/projection/local_segment.h"
#include "optimized/search/gather.h"
#include "optimized/simd/lanes.h"

namespace type21::optimized {

namespace {

constexpr int group = 8;  ///< sub-triangles that are computed together

struct Rows {
    alignas(64) double edge[2][3][group];    ///< B - A, C - A [length]
    alignas(64) double normal[3][3][group];  ///< n_A, n_B, n_C [-]
    alignas(64) double extent[group], normal_size[group];
    alignas(64) double lipschitz[group], kappa_bound[group];  ///< results; the latter where it is a priori bounded
    SubTriangleId id[group];
};

template <class L>
TYPE21_INLINE void largest_of(const VectorLanes<L>& v, L& most) {
    L other;
    magnitude_of(v.x, most);
    magnitude_of(v.y, other);
    most_of(other, most);
    magnitude_of(v.z, other);
    most_of(other, most);
}
template <class L>
TYPE21_INLINE void length_of(const VectorLanes<L>& v, L& length) {
    L square;
    dot_of(v, v, square);
    root_of(square, length);
}

/// The input of both kinds of bounds.
template <class L>
struct SubTriangleLanes {
    VectorLanes<L> e1, e2, area, n[3];
    L d2, length, slope[3], least_slope, most_slope;  ///< <n, N>
};

/// Line by line the bounds of filter(), with the largest values that their variables can have: S is a_priori_size, |H|
/// is growth |N|, |p| and |q| are 4, W is 1/2, weights of step 2 lie between -0.01 and 1.02. `more` stands for what
/// filter() calls second order, and for the rounding of the bounds themselves.
/// Conditions are counted: GCC takes apart what joins several comparisons.
template <class L>
TYPE21_INLINE void a_priori_bounded(const SubTriangleLanes<L>& t, const L& extent, const L& nm, double growth, L& met,
                                    L& kappa_bound) {
    constexpr double e = 0x1p-53, more = 1.05, ordinary = 1e30;
    const L zero = extent - extent, one = zero + 1.0;
    const L s = extent + 1.5 * growth;
    L area_size, edge, other;
    largest_of(t.area, area_size);
    largest_of(t.e1, edge);
    largest_of(t.e2, other);
    most_of(other, edge);
    met = s > 1 / ordinary ? one : zero;
    met += s < ordinary ? one : zero;
    met += nm > 1e-10 ? one : zero;
    met += nm < 1e10 ? one : zero;
    met += area_size > 1e-12 * s * s ? one : zero;
    const L eta = 48 * e * s * s / area_size * more;
    const L gm = 2.0 * edge * area_size / t.d2 * more, aspect = gm * s;
    VectorLanes<L> g1, g2;
    cross_of(t.e2, t.area, g1);
    scale(g1, 1.0 / t.d2);
    cross_of(t.area, t.e1, g2);
    scale(g2, 1.0 / t.d2);
    L sideways = zero;
    for (int i = 0; i < 3; ++i) {
        dot_of(t.n[i], g1, other);
        magnitude_of(other, other);
        most_of(other, sideways);
        dot_of(t.n[i], g2, other);
        magnitude_of(other, other);
        most_of(other, sideways);
    }
    sideways += 17.0 * eta * nm * gm;
    const L height_bound = 6.6 * eta * area_size * s, slope_bound = 3.7 * eta * nm * area_size;
    met += slope_bound < 0.01 * t.least_slope ? one : zero;
    const L length = t.length * more;
    const L sure_slope = t.least_slope - slope_bound;
    const L r_size = growth * length / sure_slope * more, w = nm * area_size / sure_slope;
    const L coordinate_bound = eta * (30.0 + 21.0 * w) * (aspect + gm * nm * r_size) * more;
    const L z = 5.0 + r_size * sideways * more;
    const L weight_error = (4.1 * z * coordinate_bound + 8 * e * z * z) * more;
    const L db = 4.5 * weight_error / (0.5 - 4.0 * weight_error) + 4 * e;
    const L interpolated_bound = 3.1 * db * t.most_slope + 15.0 * eta * nm * area_size;
    met += coordinate_bound < a_priori_share ? one : zero;
    met += eta * w < a_priori_share ? one : zero;
    met += weight_error < 0.01 ? one : zero;
    met += db < 0.5 * a_priori_share ? one : zero;
    met += interpolated_bound < 1e-3 * t.least_slope ? one : zero;
    // With weights >= -0.01 in step 2, up to db, at most two of them are negative, and the third is at most 1.02.
    const L slope = 0.99 * (1.02 * t.least_slope - 0.02 * t.most_slope);
    met += slope > 0.5 * t.least_slope ? one : zero;
    const L lift = growth * length / slope;
    const L lift_bound = (height_bound + lift * interpolated_bound) / slope * more + e * lift;
    const L n_bound = 9.1 * db * sideways + 59.0 * eta * nm * gm;
    const L q_bound = (29.0 * eta * aspect + sideways * 1.1 * lift_bound + (lift + lift_bound) * n_bound +
                       3 * e * (sideways * 1.1 * lift + 4.0)) *
                      more;
    // delta = lift |n|, |n| <= 2 nm, its error 3.3 db nm and rounding.
    const L distance_bound = (lift_bound * 2.0 * nm + lift * nm * (6.0 * db + 20 * e)) * more;
    kappa_bound = 4.1 * q_bound + 12.0 * e;
    met += 3.0 * q_bound < a_priori_share ? one : zero;
    met += distance_bound < a_priori_share * s ? one : zero;
    met += height_bound < a_priori_share * s * area_size ? one : zero;
}
constexpr double all_conditions = 15;  ///< of `met`

template <class L>
TYPE21_INLINE void lipschitz_of(const SubTriangleLanes<L>& t, const L& extent, double growth, L& bound) {
    constexpr double weights = 1 + 4 * lipschitz_weights;  ///< sum of their magnitudes
    const L zero = extent - extent, one = zero + 1.0;
    VectorLanes<L> axis = t.area, rise[3], e3, way;
    scale(axis, 1.0 / t.length);
    L longest, other, lean = zero, apart = zero;
    length_of(t.e1, longest);
    length_of(t.e2, other);
    most_of(other, longest);
    minus(t.e2, t.e1, e3);
    length_of(e3, other);
    most_of(other, longest);
    const L width = t.length / longest;
    // As in capture_volume(): the plane is trusted, and no normal leans too far. Slopes are those of N, nu times its
    // length.
    L met = 64 * 0x1p-53 * 4.0 * extent * extent < 1e-11 * t.length ? one : zero;
    for (int i = 0; i < 3; ++i) {
        length_of(t.n[i], other);
        met += t.slope[i] > 0.05 * other * t.length ? one : zero;
        rise[i] = t.n[i];
        scale(rise[i], t.length / t.slope[i]);
    }
    for (int i = 0; i < 3; ++i) {
        minus(rise[i], axis, way);
        length_of(way, other);
        most_of(other, lean);
        minus(rise[i], rise[(i + 1) % 3], way);
        length_of(way, other);
        most_of(other, apart);
    }
    const L height = growth + lipschitz_reach * width, lifted = width - height * apart;
    const L sum = (1 + 2 * lipschitz_weights) * t.least_slope - 2 * lipschitz_weights * t.most_slope;
    met += lifted > 0.05 * width ? one : zero;
    met += sum > 0.05 * t.most_slope ? one : zero;
    const L share = weights * t.most_slope / sum;
    L g, longer;
    root_of(1.0 + weights * lean * (weights * lean), g);
    g /= lifted;
    root_of(1.0 + share * lean * (share * lean), longer);
    bound = (longer + height * 2.0 * g * share * share * apart) / width;
    most_of(g, bound);
    bound = met == 6.0 ? bound * (1 + 1e-5) : zero + no_lipschitz;
}

template <int W>
TYPE21_INLINE void bounds_in(Rows& rows, int at, double growth) {
    using L = Lanes<W>;
    SubTriangleLanes<L> t;
    L extent, normal_size, met, lipschitz, kappa_bound, other;
    load(rows.edge[0][0] + at, rows.edge[0][1] + at, rows.edge[0][2] + at, t.e1);
    load(rows.edge[1][0] + at, rows.edge[1][1] + at, rows.edge[1][2] + at, t.e2);
    load(rows.extent + at, extent);
    load(rows.normal_size + at, normal_size);
    cross_of(t.e1, t.e2, t.area);
    dot_of(t.area, t.area, t.d2);
    root_of(t.d2, t.length);
    for (int i = 0; i < 3; ++i) {
        load(rows.normal[i][0] + at, rows.normal[i][1] + at, rows.normal[i][2] + at, t.n[i]);
        dot_of(t.n[i], t.area, t.slope[i]);
        magnitude_of(t.slope[i], other);
        if (i == 0) {
            t.least_slope = t.slope[i];
            t.most_slope = other;
        }
        least_of(t.slope[i], t.least_slope);
        most_of(other, t.most_slope);
    }
    a_priori_bounded(t, extent, normal_size, growth, met, kappa_bound);
    lipschitz_of(t, extent, growth, lipschitz);
    const L zero = extent - extent;
    store(met == all_conditions ? lipschitz : zero + HUGE_VAL, rows.lipschitz + at);
    store(kappa_bound, rows.kappa_bound + at);
}

template <int W>
TYPE21_INLINE void bounds_all(Rows& rows, double growth) {
    for (int at = 0; at < group; at += W)
        bounds_in<W>(rows, at, growth);
}
TYPE21_AVX512 void bounds_eight(Rows& rows, double growth) {
    bounds_all<8>(rows, growth);
}
TYPE21_AVX2 void bounds_four(Rows& rows, double growth) {
    bounds_all<4>(rows, growth);
}
void bounds_two(Rows& rows, double growth) {
    bounds_all<2>(rows, growth);
}

void put(Rows& rows, int column, const SegmentData& segment, const LocalSegment& local, int k) {
    const SubTriangleCorners corner = sub_triangle_corners(segment.is_triangle, k);
    const V3 e[2] = {local.corner[static_cast<size_t>(corner.b)] - local.center,
                     local.corner[static_cast<size_t>(corner.c)] - local.center};
    const V3 n[3] = {local.center_normal, segment.normal[static_cast<size_t>(corner.b)],
                     segment.normal[static_cast<size_t>(corner.c)]};
    for (int a = 0; a < 3; ++a) {
        for (int i = 0; i < 2; ++i)
            rows.edge[i][a][column] = e[i][a];
        for (int i = 0; i < 3; ++i)
            rows.normal[i][a][column] = n[i][a];
    }
    rows.normal_size[column] = local.normal_size;
}

}  // namespace

LipschitzBounds lipschitz_bounds(const Tool& tool, double growth, SimdWidth machine) {
    LipschitzBounds bounds;
    bounds.lipschitz.assign(4 * static_cast<size_t>(tool.size()), HUGE_VALF);
    bounds.kappa_bits.assign(static_cast<size_t>(tool.size()), 255);
    const auto compute = compiled_for(machine, bounds_eight, bounds_four, bounds_two);
    tbb::parallel_for(tbb::blocked_range<int>(0, tool.size(), 1024), [&](const tbb::blocked_range<int>& range) {
        Rows rows{};
        int column = 0;
        const auto flush = [&] {
            compute(rows, growth);
            for (int c = 0; c < column; ++c) {
                bounds.lipschitz[static_cast<size_t>(rows.id[c].code())] =
                    std::nextafter(static_cast<float>(rows.lipschitz[c]), HUGE_VALF);
                if (!std::isfinite(rows.lipschitz[c])) continue;
                std::uint8_t& bits = bounds.kappa_bits[static_cast<size_t>(rows.id[c].segment())];
                bits = static_cast<std::uint8_t>(std::clamp(-std::ilogb(rows.kappa_bound[c]) - 1, 0, int(bits)));
            }
            column = 0;
        };
        for (int s = range.begin(); s < range.end(); ++s) {
            const SegmentData segment = tool.segment(s);
            const LocalSegment local = local_segment(segment);
            for (int k = 1; k <= segment.sub_triangles(); ++k) {
                put(rows, column, segment, local, k);
                rows.extent[column] = tool.extent(s);
                rows.id[column++] = {s, k};
                if (column == group) flush();
            }
        }
        flush();
    });
    return bounds;
}

}  // namespace type21::optimized
