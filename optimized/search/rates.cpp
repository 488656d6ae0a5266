#include "optimized/search/rates.h"

#include <algorithm>
#include <cmath>

namespace type21::optimized {

double weight_rate(const SegmentData& segment, int k, const Limits& limits) {
    constexpr double none = std::numeric_limits<double>::infinity();
    constexpr double weights = 1 + 4 * rate_weights;  ///< sum of their magnitudes
    const Prism p = prism(segment, k, limits);
    // Where normals lean too far there is no lift, only the plane.
    if (p.grown || (p.low == 0 && p.high == 0)) return none;
    const PieceCorners of = piece_corners(segment.triangle, k);
    const V3 a = segment.triangle
                     ? segment.normal[2]
                     : ((segment.normal[0] + segment.normal[1]) + (segment.normal[2] + segment.normal[3])) * 0.25;
    const double nu[3] = {dot(a, p.axis), dot(segment.normal[static_cast<size_t>(of.b)], p.axis),
                          dot(segment.normal[static_cast<size_t>(of.c)], p.axis)};
    const double most = std::max(nu[0], std::max(nu[1], nu[2])), least = std::min(nu[0], std::min(nu[1], nu[2]));
    double lean = 0, apart = 0, longest = 0;
    for (size_t i = 0; i < 3; ++i) {
        lean = std::max(lean, norm(p.rise[i] - p.axis));
        apart = std::max(apart, norm(p.rise[i] - p.rise[(i + 1) % 3]));
        longest = std::max(longest, norm(p.corner[i] - p.corner[(i + 1) % 3]));
    }
    const double width = norm(cross(p.corner[1] - p.corner[0], p.corner[2] - p.corner[0])) / longest;
    const double height = p.growth + 0.05 * width, lifted = width - height * apart;
    const double sum = (1 + 2 * rate_weights) * least - 2 * rate_weights * most;
    if (!(lifted > 0.05 * width && sum > 0.05 * most)) return none;
    const double share = weights * most / sum;
    const double g = std::hypot(1, weights * lean) / lifted;
    const double way = std::hypot(1, share * lean) + height * 2 * g * share * share * apart;
    return std::max(g, way / width) * (1 + 1e-5);
}

}  // namespace type21::optimized
