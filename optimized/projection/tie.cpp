#include "optimized/projection/tie.h"

#include "optimized/projection/exact_vector.h"

namespace type21::optimized {

namespace {

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

bool above(const V3& p, const V3& at, const V3& normal) {
    // Mostly the normal is along an axis. Then two coordinates decide.
    const V3 apart{p.x == at.x ? 0.0 : 1.0, p.y == at.y ? 0.0 : 1.0, p.z == at.z ? 0.0 : 1.0};
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        if (normal[j] == 0 && normal[k] == 0) return apart[j] == 0 && apart[k] == 0;
    }
    return parallel(way(at, p), exact(normal));
}

bool above_centre(const V3& p, const SegmentData& s) {
    const ExactVector at = sum_of(s.node);
    return at.known && parallel(way_from_sum(at, p), sum_of(s.normal));
}

bool over(const V3& p, const V3& v, const V3& nv, const V3& w, const V3& nw) {
    // Often the plane is normal to an axis.
    for (int i = 0; i < 3; ++i)
        if (v[i] == w[i] && p[i] == v[i] && nv[i] == 0 && nw[i] == 0) return true;
    const ExactVector along = way(v, w), normal = exact(nv);
    return in_one_plane(along, normal, way(v, p)) && in_one_plane(along, normal, exact(nw));
}

/// The same for the edge from the centre to node j.
bool over_diagonal(const V3& p, const SegmentData& s, size_t j) {
    const ExactVector at = sum_of(s.node);
    const ExactVector along = way_from_sum(at, s.node[j]), normal = exact(s.normal[j]);
    return in_one_plane(along, normal, way(s.node[j], p)) && in_one_plane(along, normal, sum_of(s.normal));
}

bool over_edge(const V3& p, const SegmentData& s, int i, int j) {
    const auto v = static_cast<size_t>(i), w = static_cast<size_t>(j);
    return over(p, s.node[v], s.normal[v], s.node[w], s.normal[w]);
}

/// k where the two are sub-triangles k and k + 1 of a quad, else 0.
int first_of_neighbours(int one, int other) {
    const int k = std::min(one, other), next = std::max(one, other);
    if (k == 1 && next == 4) return 4;
    return next == k + 1 ? k : 0;
}

class Ties {
  public:
    Ties(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
         const ContactReach& reach, const ProjectionLimits& rules)
        : p_(p), contenders_(contenders), segments_(segments), reach_(reach), rules_(rules) {}

    bool all_above_corners() const {
        TieCorner last;
        for (size_t c = 0; c < contenders_.size(); ++c) {
            const Contender& one = contenders_[c];
            if (c > 0 && last.of(one.id, segments_[c])) continue;
            if (!corner_below(p_, one.id, segments_[c], last)) return false;
        }
        return true;
    }

    /// All contenders are linked by pairs that are tied.
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
        if (contenders_[i].id.segment() == contenders_[j].id.segment()) return in_one_quad(i, j);
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
        const int k = first_of_neighbours(contenders_[i].id.triangle(), contenders_[j].id.triangle());
        if (k == 0) return false;
        if (over_diagonal(p_, s, static_cast<size_t>(k % 4))) return true;
        if (!parallelogram(s.node)) return false;
        if (!equal(s.normal[0], s.normal[1]) || !equal(s.normal[0], s.normal[2]) || !equal(s.normal[0], s.normal[3]))
            return false;
        const FilterResult projected = filter(p_, s, local_segment(s), k, reach_, rules_);
        return projected.verdict == Verdict::taken &&
               projected.projection.c - 2.0 / 3 - std::abs(projected.projection.b) >
                   4 * projected.projection.weight_bound;
    }
    /// Corners that are nodes, -1: none.
    std::array<int, 3> nodes(size_t i) const {
        const SubTriangleCorners k = sub_triangle_corners(segments_[i].is_triangle, contenders_[i].id.triangle());
        return {k.b, k.c, segments_[i].is_triangle ? 2 : -1};
    }
    static const V3& node(const SegmentData& s, int j) { return s.node[static_cast<size_t>(j)]; }
    static const V3& normal(const SegmentData& s, int j) { return s.normal[static_cast<size_t>(j)]; }

    const V3& p_;
    std::span<const Contender> contenders_;
    std::span<const SegmentData> segments_;
    const ContactReach& reach_;
    const ProjectionLimits& rules_;
};

}  // namespace

bool above_corner(const V3& p, const SegmentData& segment, int k, int corner) {
    if (corner == 0 && !segment.is_triangle) return above_centre(p, segment);
    const SubTriangleCorners corners = sub_triangle_corners(segment.is_triangle, k);
    const auto j = static_cast<size_t>(corner == 0 ? 2 : (corner == 1 ? corners.b : corners.c));
    return above(p, segment.node[j], segment.normal[j]);
}

bool corner_below(const V3& p, SubTriangleId id, const SegmentData& segment, TieCorner& corner) {
    const SubTriangleCorners corners = sub_triangle_corners(segment.is_triangle, id.triangle());
    for (const int j : {corners.b, corners.c, segment.is_triangle ? 2 : -1}) {
        if (j < 0) continue;
        const V3 &at = segment.node[static_cast<size_t>(j)], &normal = segment.normal[static_cast<size_t>(j)];
        if (!above(p, at, normal)) continue;
        corner = {-1, at, normal};
        return true;
    }
    if (segment.is_triangle || !above_centre(p, segment)) return false;
    corner = {id.segment(), {}, {}};
    return true;
}

bool over_side(const V3& p, const SegmentData& segment, int k, int corner) {
    const SubTriangleCorners corners = sub_triangle_corners(segment.is_triangle, k);
    const std::array<int, 3> node{2, corners.b, corners.c};
    const int i = node[static_cast<size_t>((corner + 1) % 3)], j = node[static_cast<size_t>((corner + 2) % 3)];
    if (corner == 0 || segment.is_triangle) return over_edge(p, segment, i, j);
    return over_diagonal(p, segment, static_cast<size_t>(corner == 1 ? corners.c : corners.b));
}

bool tied(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
          const ContactReach& reach, const ProjectionLimits& rules) {
    bool sure = true, at_corner = true;
    for (const Contender& one : contenders) {
        sure = sure && !one.unsure;
        at_corner = at_corner && one.low < kappa_above_corner + 1e-15 && one.high > kappa_above_corner - 1e-15;
    }
    if (!sure) return false;
    const Ties ties(p, contenders, segments, reach, rules);
    return (at_corner && ties.all_above_corners()) || ties.linked();
}

}  // namespace type21::optimized
