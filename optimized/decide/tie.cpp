#include "optimized/decide/tie.h"

#include "optimized/decide/zero_sum.h"

namespace type21::optimized {

namespace {

constexpr double alone_on_corner = 4.0 / 3;  ///< kappa

bool equal(const V3& p, const V3& q) {
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

bool parallelogram(const std::array<V3, 4>& x) {
    for (int i = 0; i < 3; ++i) {
        const TwoDoubles one = TwoDoubles::exact_sum(x[0][i], x[2][i]);
        const TwoDoubles other = TwoDoubles::exact_sum(x[1][i], x[3][i]);
        if (one.high != other.high || one.low != other.low) return false;
    }
    return true;
}

/// A vector whose components are exact sums of two doubles, where `known`.
struct Exact {
    std::array<double, 3> high{}, low{};
    bool known = true;

    void put(size_t i, const TwoDoubles& v) {
        high[i] = v.high;
        low[i] = v.low;
        known = known && ZeroSum::ordinary(v.high) && ZeroSum::ordinary(v.low);
    }
};

Exact exact(const V3& v) {
    Exact e;
    for (size_t i = 0; i < 3; ++i)
        e.put(i, v[static_cast<int>(i)]);
    return e;
}

/// q - p.
Exact way(const V3& p, const V3& q) {
    Exact e;
    for (int i = 0; i < 3; ++i)
        e.put(static_cast<size_t>(i), TwoDoubles::exact_sum(q[i], -p[i]));
    return e;
}

/// The sum of four; unknown where it needs more than two doubles.
Exact sum_of(const std::array<V3, 4>& x) {
    Exact e;
    for (int i = 0; i < 3; ++i) {
        const TwoDoubles one = TwoDoubles::exact_sum(x[0][i], x[2][i]);
        const TwoDoubles other = TwoDoubles::exact_sum(x[1][i], x[3][i]);
        TwoDoubles high = TwoDoubles::exact_sum(one.high, other.high);
        if (one.low != 0 || other.low != 0) {
            const TwoDoubles low = TwoDoubles::exact_sum(one.low, other.low);
            e.known = e.known && high.low == 0 && low.low == 0;
            high.low = low.high;
        }
        e.put(static_cast<size_t>(i), high);
    }
    return e;
}

/// 4 p - sum: four times the way from the centre.
Exact way_from_sum(const Exact& sum, const V3& p) {
    Exact e;
    for (size_t i = 0; i < 3; ++i) {
        TwoDoubles d = TwoDoubles::exact_sum(4 * p[static_cast<int>(i)], -sum.high[i]);
        if (sum.low[i] != 0) {
            e.known = e.known && d.low == 0;
            d.low = -sum.low[i];
        }
        e.put(i, d);
    }
    e.known = e.known && sum.known;
    return e;
}

/// x = 0 is not excluded by the rounding of its terms, whose sizes sum up to `size`.
bool may_be_zero(double x, double size) {
    return std::abs(x) <= 1e-14 * size;
}

bool parallel(const Exact& p, const Exact& q) {
    if (!p.known || !q.known) return false;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3;
        const double one = p.high[i] * q.high[j], other = p.high[j] * q.high[i];
        if (!may_be_zero(one - other, std::abs(one) + std::abs(other))) return false;
    }
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3;
        ZeroSum sum;
        for (const auto& pi : {p.high, p.low}) {
            for (const auto& qi : {q.high, q.low}) {
                sum.add(pi[i], qi[j]);
                sum.add(-pi[j], qi[i]);
            }
        }
        if (!sum.zero()) return false;
    }
    return true;
}

bool in_one_plane(const Exact& p, const Exact& q, const Exact& r) {
    if (!p.known || !q.known || !r.known) return false;
    double value = 0, size = 0;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double one = p.high[i] * q.high[j] * r.high[k], other = p.high[i] * q.high[k] * r.high[j];
        value += one - other;
        size += std::abs(one) + std::abs(other);
    }
    if (!may_be_zero(value, size)) return false;
    ZeroSum sum;
    for (const auto& pi : {p.high, p.low}) {
        for (const auto& qi : {q.high, q.low}) {
            for (const auto& ri : {r.high, r.low}) {
                for (size_t i = 0; i < 3; ++i) {
                    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
                    sum.add(pi[i], qi[j], ri[k]);
                    sum.add(-pi[i], qi[k], ri[j]);
                }
            }
        }
    }
    return sum.zero();
}

bool above(const V3& p, const V3& at, const V3& normal) {
    // Mostly the normal is along an axis, and then two coordinates say it.
    const V3 apart{p.x == at.x ? 0.0 : 1.0, p.y == at.y ? 0.0 : 1.0, p.z == at.z ? 0.0 : 1.0};
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        if (normal[j] == 0 && normal[k] == 0) return apart[j] == 0 && apart[k] == 0;
    }
    return parallel(way(at, p), exact(normal));
}

bool above_centre(const V3& p, const SegmentData& s) {
    const Exact at = sum_of(s.node);
    return at.known && parallel(way_from_sum(at, p), sum_of(s.normal));
}

bool over(const V3& p, const V3& v, const V3& nv, const V3& w, const V3& nw) {
    // Often the plane is normal to an axis.
    for (int i = 0; i < 3; ++i)
        if (v[i] == w[i] && p[i] == v[i] && nv[i] == 0 && nw[i] == 0) return true;
    const Exact along = way(v, w), normal = exact(nv);
    return in_one_plane(along, normal, way(v, p)) && in_one_plane(along, normal, exact(nw));
}

/// The same for the edge from the centre to node j.
bool over_diagonal(const V3& p, const SegmentData& s, size_t j) {
    const Exact at = sum_of(s.node);
    const Exact along = way_from_sum(at, s.node[j]), normal = exact(s.normal[j]);
    return in_one_plane(along, normal, way(s.node[j], p)) && in_one_plane(along, normal, sum_of(s.normal));
}

bool over_edge(const V3& p, const SegmentData& s, int i, int j) {
    const auto v = static_cast<size_t>(i), w = static_cast<size_t>(j);
    return over(p, s.node[v], s.normal[v], s.node[w], s.normal[w]);
}

/// The pieces k and k + 1 of a quad, k; 0: they are no such pieces.
int first_of_neighbours(int one, int other) {
    const int k = std::min(one, other), next = std::max(one, other);
    if (k == 1 && next == 4) return 4;
    return next == k + 1 ? k : 0;
}

class Ties {
  public:
    Ties(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
         const Window& window, const Rules& rules)
        : p_(p), contenders_(contenders), segments_(segments), window_(window), rules_(rules) {}

    bool all_above_corners() const {
        const V3 *at = nullptr, *direction = nullptr;  // the last one that the node was above
        for (size_t c = 0; c < contenders_.size(); ++c) {
            const SegmentData& s = segments_[c];
            if (c > 0 && contenders_[c].segment == contenders_[c - 1].segment && at == nullptr) continue;
            bool found = false;
            for (const int j : nodes(c)) {
                if (found || j < 0) continue;
                const V3 &x = node(s, j), &n = normal(s, j);
                found = at != nullptr && equal(x, *at) && equal(n, *direction);
                if (found || !above(p_, x, n)) continue;
                at = &x;
                direction = &n;
                found = true;
            }
            if (found) continue;
            if (s.triangle || !above_centre(p_, s)) return false;
            at = direction = nullptr;
        }
        return true;
    }

    /// All of them in one chain of pairs.
    bool linked() const {
        const size_t count = contenders_.size();
        if (count > 16) return false;
        std::array<bool, 16> in{true};
        std::array<size_t, 16> queue{0};
        size_t last = 1;
        for (size_t next = 0; next < last; ++next) {
            for (size_t c = 1; c < count; ++c) {
                if (in[c] || !pair(queue[next], c)) continue;
                in[c] = true;
                queue[last++] = c;
            }
        }
        return last == count;
    }

  private:
    bool pair(size_t i, size_t j) const {
        if (contenders_[i].segment == contenders_[j].segment) return in_one_quad(i, j);
        const SegmentData &s = segments_[i], &t = segments_[j];
        const std::array<int, 3> own = nodes(i), its = nodes(j);
        std::array<int, 3> shared;
        int count = 0;
        for (const int a : own) {
            bool has = false;
            for (const int b : its)
                has = has || (a >= 0 && b >= 0 && equal(node(s, a), node(t, b)) && equal(normal(s, a), normal(t, b)));
            if (has) shared[static_cast<size_t>(count++)] = a;
        }
        for (int a = 0; a < count; ++a)
            for (int b = a + 1; b < count; ++b)
                if (over_edge(p_, s, shared[static_cast<size_t>(a)], shared[static_cast<size_t>(b)])) return true;
        return false;
    }
    bool in_one_quad(size_t i, size_t j) const {
        const SegmentData& s = segments_[i];
        const int k = first_of_neighbours(contenders_[i].piece, contenders_[j].piece);
        if (k == 0) return false;
        if (over_diagonal(p_, s, static_cast<size_t>(k % 4))) return true;
        if (!parallelogram(s.node)) return false;
        if (!equal(s.normal[0], s.normal[1]) || !equal(s.normal[0], s.normal[2]) || !equal(s.normal[0], s.normal[3]))
            return false;
        const FilterResult landed = filter(p_, s, local_segment(s), k, window_, rules_);
        return landed.verdict == Verdict::taken &&
               landed.landing.c - 2.0 / 3 - std::abs(landed.landing.b) > 4 * landed.landing.weight_bound;
    }
    /// Corners that are nodes, -1: none.
    std::array<int, 3> nodes(size_t i) const {
        const PieceCorners k = piece_corners(segments_[i].triangle, contenders_[i].piece);
        return {k.b, k.c, segments_[i].triangle ? 2 : -1};
    }
    static const V3& node(const SegmentData& s, int j) { return s.node[static_cast<size_t>(j)]; }
    static const V3& normal(const SegmentData& s, int j) { return s.normal[static_cast<size_t>(j)]; }

    const V3& p_;
    std::span<const Contender> contenders_;
    std::span<const SegmentData> segments_;
    const Window& window_;
    const Rules& rules_;
};

}  // namespace

bool above_corner(const V3& p, const SegmentData& segment, int k, int corner) {
    if (corner == 0 && !segment.triangle) return above_centre(p, segment);
    const PieceCorners corners = piece_corners(segment.triangle, k);
    const auto j = static_cast<size_t>(corner == 0 ? 2 : (corner == 1 ? corners.b : corners.c));
    return above(p, segment.node[j], segment.normal[j]);
}

bool over_side(const V3& p, const SegmentData& segment, int k, int corner) {
    const PieceCorners corners = piece_corners(segment.triangle, k);
    const std::array<int, 3> node{2, corners.b, corners.c};
    const int i = node[static_cast<size_t>((corner + 1) % 3)], j = node[static_cast<size_t>((corner + 2) % 3)];
    if (corner == 0 || segment.triangle) return over_edge(p, segment, i, j);
    return over_diagonal(p, segment, static_cast<size_t>(corner == 1 ? corners.c : corners.b));
}

bool tied(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
          const Window& window, const Rules& rules) {
    bool sure = true, at_corner = true;
    for (const Contender& one : contenders) {
        sure = sure && !one.unsure;
        at_corner = at_corner && one.low < alone_on_corner + 1e-15 && one.high > alone_on_corner - 1e-15;
    }
    if (!sure) return false;
    const Ties ties(p, contenders, segments, window, rules);
    return (at_corner && ties.all_above_corners()) || ties.linked();
}

}  // namespace type21::optimized
