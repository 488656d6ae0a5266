#include "verification/bench/plain_search.h"

#include <algorithm>
#include <cmath>

#include "optimized/decide/local_segment.h"

namespace type21::bench {

namespace {

using optimized::LocalSegment;
using optimized::SegmentData;
using optimized::V3;
using optimized::Window;

constexpr double low = -0.01, high = 1.01;

bool outside(double b, double c, double total) {
    return b < low * total || c < low * total || b + c > high * total;
}

struct Landed {
    Kind kind = Kind::none;
    int side = 0;
    double b = 0, c = 0, kappa = 0;
};

/// Formulation section 3 in the coordinates of the triangle, A = (0, 0), B = (1, 0), C = (0, 1).
Landed land(const V3& p, const SegmentData& segment, const LocalSegment& local, int k, const Window& window) {
    const optimized::PieceCorners corner = optimized::piece_corners(segment.triangle, k);
    const V3& nb = segment.normal[static_cast<size_t>(corner.b)];
    const V3& nc = segment.normal[static_cast<size_t>(corner.c)];
    const V3& na = local.center_normal;
    const V3 e1 = local.corner[static_cast<size_t>(corner.b)] - local.center;
    const V3 e2 = local.corner[static_cast<size_t>(corner.c)] - local.center;
    const V3 u = (p - local.origin) - local.center;
    const V3 area = cross(e1, e2);
    const double of_square = 1 / dot(area, area);
    const double height = dot(u, area);
    const double slope_a = dot(na, area), slope_b = dot(nb, area), slope_c = dot(nc, area);
    if (!(slope_a > 0 && slope_b > 0 && slope_c > 0)) return {};
    const V3 g1 = cross(e2, area) * of_square, g2 = cross(area, e1) * of_square;
    const double px = dot(u, g1), py = dot(u, g2);
    const double xa = dot(na, g1), ya = dot(na, g2), xb = dot(nb, g1), yb = dot(nb, g2), xc = dot(nc, g1),
                 yc = dot(nc, g2);
    const double ra = height / slope_a, rb = height / slope_b, rc = height / slope_c;
    const double ax = ra * xa - px, ay = ra * ya - py;
    const double bx = 1 + rb * xb - px, by = rb * yb - py;
    const double cx = rc * xc - px, cy = 1 + rc * yc - py;
    const double wa = bx * cy - by * cx, wb = cx * ay - cy * ax, wc = ax * by - ay * bx, total = wa + wb + wc;
    if (!(total > 0) || outside(wb, wc, total)) return {};
    const double inverse = 1 / total, a1 = wa * inverse, b1 = wb * inverse, c1 = wc * inverse;
    const double slope = a1 * slope_a + b1 * slope_b + c1 * slope_c;
    if (!(slope > 0)) return {};
    const double lift = height / slope;
    Landed out;
    out.b = px - (a1 * xa + b1 * xb + c1 * xc) * lift;
    out.c = py - (a1 * ya + b1 * yb + c1 * yc) * lift;
    if (outside(out.b, out.c, 1)) return {};
    const double ca = std::clamp(1 - out.b - out.c, 0.0, 1.0), cb = std::clamp(out.b, 0.0, 1.0),
                 cc = std::clamp(out.c, 0.0, 1.0), sum = ca + cb + cc;
    const V3 offset = u - (e1 * (cb / sum) + e2 * (cc / sum));
    const double distance2 = dot(offset, offset);
    out.side = height < 0 ? -1 : 1;
    const double limit = out.side > 0 ? window.gap : window.depth;
    if (distance2 < limit * limit)
        out.kind = Kind::contact;
    else if (out.side > 0 && distance2 < window.proximity * window.proximity)
        out.kind = Kind::proximity;
    out.kappa = std::abs(1.0 / 3 - out.b) + std::abs(1.0 / 3 - out.c) + std::abs(2.0 / 3 - out.b - out.c);
    return out;
}

}  // namespace

PlainSearch::PlainSearch(const optimized::Tool& tool, const optimized::Limits& limits) : tool_(tool) {
    std::vector<optimized::Box> boxes(static_cast<size_t>(tool.size()));
    for (int s = 0; s < tool.size(); ++s) {
        const SegmentData segment = tool.segment(s);
        for (int k = 1; k <= segment.pieces(); ++k)
            boxes[static_cast<size_t>(s)].extend(prism(segment, k, limits).box());
    }
    tree_ = optimized::BoxTree(boxes);
}

Decision PlainSearch::at(const V3& y, const Window& window) const {
    Decision best;
    double kappa = 0;
    tree_.at(y, [&](int s) {
        const SegmentData segment = tool_.segment(s);
        const LocalSegment local = local_segment(segment);
        for (int k = 1; k <= segment.pieces(); ++k) {
            const Landed one = land(y, segment, local, k, window);
            if (one.kind == Kind::none) continue;
            bool better = best.kind == Kind::none;
            if (!better && one.kind != best.kind)
                better = one.kind == Kind::contact;
            else if (!better)
                better = one.kappa < kappa ||
                         (one.kappa == kappa && (s < best.segment || (s == best.segment && k < best.triangle)));
            if (!better) continue;
            best = {one.kind, s, k, one.side, one.b, one.c, Stage::bounded};
            kappa = one.kappa;
        }
    });
    return best;
}

}  // namespace type21::bench
