#include "optimized/decide/tie.h"

namespace type21::optimized {

namespace {

bool equal(const V3& p, const V3& q) {
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

/// p x = q y exactly.
bool same_product(double p, double x, double q, double y) {
    const TwoDoubles one = TwoDoubles::exact_product(p, x), other = TwoDoubles::exact_product(q, y);
    return one.high == other.high && one.low == other.low;
}

/// In this range products of two numbers and their low parts neither overflow nor underflow.
bool ordinary(const V3& v) {
    const auto good = [](double x) { return x == 0 || (std::abs(x) > 1e-100 && std::abs(x) < 1e100); };
    return good(v.x) && good(v.y) && good(v.z);
}

/// A corner with its normal.
struct Corner {
    V3 at, normal;
    bool is(const Corner& other) const { return equal(at, other.at) && equal(normal, other.normal); }
};

/// Corners of a piece that are nodes of the mesh: B and C, of a triangle A too.
struct Corners {
    Corner corner[3];
    int count = 0;
    bool hold(const Corner& one) const {
        for (int i = 0; i < count; ++i)
            if (corner[i].is(one)) return true;
        return false;
    }
};

Corners corners_of(const SegmentData& s, int piece) {
    const PieceCorners k = piece_corners(s.triangle, piece);
    Corners corners;
    const auto put = [&](int j) {
        corners.corner[corners.count++] = {s.node[static_cast<size_t>(j)], s.normal[static_cast<size_t>(j)]};
    };
    put(k.b);
    put(k.c);
    if (s.triangle) put(2);
    return corners;
}

/// P - V is parallel to n_V; proven only where the difference is exact.
bool above(const V3& p, const Corner& v) {
    const auto difference = [](double x, double y) { return TwoDoubles::exact_sum(x, -y); };
    const TwoDoubles x = difference(p.x, v.at.x), y = difference(p.y, v.at.y), z = difference(p.z, v.at.z);
    if (x.low != 0 || y.low != 0 || z.low != 0) return false;
    const V3 d{x.high, y.high, z.high};
    const V3& n = v.normal;
    return ordinary(d) && ordinary(n) && same_product(d.x, n.y, d.y, n.x) && same_product(d.y, n.z, d.z, n.y) &&
           same_product(d.z, n.x, d.x, n.z);
}

/// Does every node of the segment but those two lie strictly on one side of x_i = level?
bool third_off(const SegmentData& s, const Corner& v, const Corner& w, int i) {
    const double level = v.at[i];
    int above = 0, below = 0;
    for (size_t j = 0; j < (s.triangle ? 3 : 4); ++j) {
        if (equal(s.node[j], v.at) || equal(s.node[j], w.at)) continue;
        above += s.node[j][i] > level;
        below += s.node[j][i] < level;
    }
    return (above > 0) != (below > 0);
}

/// The first axis >= from across which the edge, its normals and P do not extend; 3: none.
int edge_axis(const V3& p, const Corner& v, const Corner& w, int from) {
    for (int i = from; i < 3; ++i)
        if (v.at[i] == w.at[i] && p[i] == v.at[i] && v.normal[i] == 0 && w.normal[i] == 0) return i;
    return 3;
}

bool exact_parallelogram(const SegmentData& s) {
    for (int i = 0; i < 3; ++i) {
        const TwoDoubles one = TwoDoubles::exact_sum(s.node[0][i], s.node[2][i]);
        const TwoDoubles other = TwoDoubles::exact_sum(s.node[1][i], s.node[3][i]);
        if (one.high != other.high || one.low != other.low) return false;
    }
    return equal(s.normal[0], s.normal[1]) && equal(s.normal[0], s.normal[2]) && equal(s.normal[0], s.normal[3]);
}

}  // namespace

bool tied(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
          const Window& window, const Rules& rules) {
    for (const Contender& one : contenders)
        if (one.unsure) return false;
    const auto all_hold = [&](const Corner& v) {
        for (size_t c = 1; c < contenders.size(); ++c)
            if (!corners_of(segments[c], contenders[c].piece).hold(v)) return false;
        return true;
    };
    const Corners first = corners_of(segments[0], contenders[0].piece);
    bool shared[3] = {};
    for (int i = 0; i < first.count; ++i) {
        shared[i] = all_hold(first.corner[i]);
        if (shared[i] && above(p, first.corner[i])) return true;
    }
    for (int i = 0; i < first.count; ++i) {
        for (int j = i + 1; j < first.count; ++j) {
            if (!shared[i] || !shared[j]) continue;
            const Corner &v = first.corner[i], &w = first.corner[j];
            if (equal(v.at, w.at)) continue;
            for (int axis = edge_axis(p, v, w, 0); axis < 3; axis = edge_axis(p, v, w, axis + 1)) {
                bool off = true;
                for (const SegmentData& s : segments)
                    off = off && third_off(s, v, w, axis);
                if (off) return true;
            }
        }
    }
    if (contenders.size() == 2 && contenders[0].segment == contenders[1].segment && !segments[0].triangle) {
        int k = std::min(contenders[0].piece, contenders[1].piece);
        const int other = std::max(contenders[0].piece, contenders[1].piece);
        if (k == 1 && other == 4) {
            k = 4;
        } else if (other != k + 1) {
            return false;
        }
        if (!exact_parallelogram(segments[0])) return false;
        const FilterResult landed = filter(p, segments[0], local_segment(segments[0]), k, window, rules);
        return landed.verdict == Verdict::taken &&
               landed.landing.c - 2.0 / 3 - std::abs(landed.landing.b) > 4 * landed.landing.weight_bound;
    }
    return false;
}

}  // namespace type21::optimized
