#include "optimized/decide/foreseen_bounds.h"

#include "optimized/decide/local_segment.h"

namespace type21::optimized {

// Line by line the bounds of filter(), with the largest values that their variables can have: S is foreseen_size, |H|
// is growth |N|, |p| and |q| are 4, W is 1/2, weights of step 2 lie between -0.01 and 1.02. `more` stands for what
// filter() calls second order, and for the rounding of the bounds themselves.
bool foreseen(const SegmentData& segment, int k, double extent, double growth) {
    constexpr double e = 0x1p-53, more = 1.05;
    const LocalSegment local = local_segment(segment);
    const PieceCorners corner = piece_corners(segment.triangle, k);
    const V3 e1 = local.corner[static_cast<size_t>(corner.b)] - local.center;
    const V3 e2 = local.corner[static_cast<size_t>(corner.c)] - local.center;
    const V3 area = cross(e1, e2);
    const double s = foreseen_size(extent, growth), nm = local.normal_size, area_size = largest(area);
    const double edge = std::max(largest(e1), largest(e2));
    const double ordinary = 1e30;
    if (!(s > 1 / ordinary && s < ordinary && nm > 1e-10 && nm < 1e10 && area_size > 1e-12 * s * s)) return false;
    const double eta = 48 * e * s * s / area_size * more;
    const double d2 = dot(area, area);
    const double gm = 2 * edge * area_size / d2 * more, aspect = gm * s;
    const std::array<V3, 3> n{local.center_normal, segment.normal[static_cast<size_t>(corner.b)],
                              segment.normal[static_cast<size_t>(corner.c)]};
    const V3 g1 = cross(e2, area) * (1 / d2), g2 = cross(area, e1) * (1 / d2);
    double least_slope = HUGE_VAL, most_slope = 0, sideways = 0;
    for (const V3& v : n) {
        least_slope = std::min(least_slope, dot(v, area));
        most_slope = std::max(most_slope, std::abs(dot(v, area)));
        sideways = std::max(sideways, std::max(std::abs(dot(v, g1)), std::abs(dot(v, g2))));
    }
    sideways += 17 * eta * nm * gm;
    const double height_bound = 6.6 * eta * area_size * s, slope_bound = 3.7 * eta * nm * area_size;
    if (!(slope_bound < 0.01 * least_slope)) return false;
    const double length = std::sqrt(d2) * more;
    const double r_size = growth * length / (least_slope - slope_bound) * more;
    const double w = nm * area_size / (least_slope - slope_bound);
    const double coordinate_bound = eta * (30 + 21 * w) * (aspect + gm * nm * r_size) * more;
    const double z = 5 + r_size * sideways * more;
    const double weight_error = (4.1 * z * coordinate_bound + 8 * e * z * z) * more;
    const double db = 4.5 * weight_error / (0.5 - 4 * weight_error) + 4 * e;
    const double interpolated_bound = 3.1 * db * most_slope + 15 * eta * nm * area_size;
    if (!(coordinate_bound < foreseen_share && eta * w < foreseen_share && db < 0.5 * foreseen_share &&
          interpolated_bound < 1e-3 * least_slope))
        return false;
    // With weights >= -0.01 in step 2, up to db, at most two of them are negative, and the third is at most 1.02.
    const double slope = 0.99 * (1.02 * least_slope - 0.02 * most_slope);
    if (!(slope > 0.5 * least_slope)) return false;
    const double lift = growth * length / slope;
    const double lift_bound = (height_bound + lift * interpolated_bound) / slope * more + e * lift;
    const double n_bound = 9.1 * db * sideways + 59 * eta * nm * gm;
    const double q_bound = (29 * eta * aspect + sideways * 1.1 * lift_bound + (lift + lift_bound) * n_bound +
                            3 * e * (sideways * 1.1 * lift + 4)) *
                           more;
    // delta = lift |n|, |n| <= 2 nm, its error 3.3 db nm and rounding.
    const double distance_bound = (lift_bound * 2 * nm + lift * nm * (6 * db + 20 * e)) * more;
    return 3 * q_bound < foreseen_share && distance_bound < foreseen_share * s &&
           height_bound < foreseen_share * s * area_size;
}

}  // namespace type21::optimized
