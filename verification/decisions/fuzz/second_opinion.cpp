#include "verification/decisions/fuzz/second_opinion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>

namespace type21 {

namespace {

using Interval = CGAL::Interval_nt<false>;
using Exact = CGAL::Mpzf;

struct Uncertain {};

int sign_of(const Interval& x) {
    if (x.inf() > 0) return 1;
    if (x.sup() < 0) return -1;
    if (x.inf() == 0 && x.sup() == 0) return 0;
    throw Uncertain();
}

int sign_of(const Exact& x) {
    return static_cast<int>(CGAL::sign(x));
}

Interval size_of(const Interval& x) {
    if (!CGAL::is_finite(x)) throw Uncertain();
    return CGAL::abs(x);
}

Exact size_of(const Exact& x) {
    return sign_of(x) < 0 ? -x : x;
}

template <class N>
using Triple = std::array<N, 3>;

template <class N>
Triple<N> taken(const Vec3& v) {
    return {N(v.x()), N(v.y()), N(v.z())};
}

template <class N>
Triple<N> minus(const Triple<N>& a, const Triple<N>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class N>
N dot(const Triple<N>& a, const Triple<N>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class N>
Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Two coordinates in the plane of the sub-triangle, times G.
template <class N>
struct Flat {
    N x{0}, y{0};
};

template <class N>
N area(const Flat<N>& a, const Flat<N>& b) {
    return a.x * b.y - a.y * b.x;
}

template <class N>
struct Corner {
    Triple<N> place, normal;
};

/// What one sub-triangle makes of the node; kappa = size / (3 scale), scale > 0.
template <class N>
struct Found {
    Kind kind = Kind::none;
    int side = 0;
    N size{0};
    N scale{1};
};

template <class N>
bool within(const N& beta, const N& gamma, const N& total) {
    const N low(-0.01);
    const N high(1.01);
    const N least = low * total;
    return sign_of(N(beta - least)) >= 0 && sign_of(N(gamma - least)) >= 0 &&
           sign_of(N(high * total - beta - gamma)) >= 0;
}

template <class N>
Found<N> found_on(const Triple<N>& p, const std::array<Corner<N>, 3>& corner, const ContactQuery& query) {
    const Triple<N> e1 = minus(corner[1].place, corner[0].place);
    const Triple<N> e2 = minus(corner[2].place, corner[0].place);
    const Triple<N> ap = minus(p, corner[0].place);
    const Triple<N> up = cross(e1, e2);
    const N square = dot(up, up);
    if (sign_of(square) == 0) return {};
    const N height = dot(ap, up);
    const int above = sign_of(height);
    std::array<N, 3> slope;
    for (size_t v = 0; v < 3; ++v) {
        slope[v] = dot(corner[v].normal, up);
        if (above != 0 && sign_of(slope[v]) <= 0) return {};
    }

    const Triple<N> f1 = cross(e2, up);
    const Triple<N> f2 = cross(up, e1);
    const Flat<N> at{dot(ap, f1), dot(ap, f2)};
    std::array<Flat<N>, 3> lean;
    std::array<Flat<N>, 3> lifted;
    for (size_t v = 0; v < 3; ++v) {
        lean[v] = {dot(corner[v].normal, f1), dot(corner[v].normal, f2)};
        const N x = v == 1 ? N(square - at.x) : N(-at.x);
        const N y = v == 2 ? N(square - at.y) : N(-at.y);
        if (above == 0)
            lifted[v] = {x, y};
        else
            lifted[v] = {slope[v] * x + height * lean[v].x, slope[v] * y + height * lean[v].y};
    }
    std::array<N, 3> weight{area(lifted[1], lifted[2]), area(lifted[2], lifted[0]), area(lifted[0], lifted[1])};
    if (above != 0)
        for (size_t v = 0; v < 3; ++v)
            weight[v] = weight[v] * slope[v];
    const N total = weight[0] + weight[1] + weight[2];
    if (sign_of(total) <= 0) return {};
    if (!within(weight[1], weight[2], total)) return {};

    N sigma(0);
    Flat<N> mean;
    for (size_t v = 0; v < 3; ++v) {
        sigma = sigma + weight[v] * slope[v];
        mean = {mean.x + weight[v] * lean[v].x, mean.y + weight[v] * lean[v].y};
    }
    if (sign_of(sigma) <= 0) return {};
    const N scale = square * sigma;
    const N b = at.x * sigma - height * mean.x;
    const N c = at.y * sigma - height * mean.y;
    if (!within(b, c, scale)) return {};

    const auto clip = [&](const N& w) {
        if (sign_of(w) < 0) return N(0);
        return sign_of(N(w - scale)) > 0 ? scale : w;
    };
    const N clipped_a = clip(N(scale - b - c));
    const N clipped_b = clip(b);
    const N clipped_c = clip(c);
    const N sum = clipped_a + clipped_b + clipped_c;
    Triple<N> offset;
    for (size_t i = 0; i < 3; ++i)
        offset[i] = ap[i] * sum - e1[i] * clipped_b - e2[i] * clipped_c;
    const N square_distance = dot(offset, offset);
    const auto nearer = [&](double limit) {
        const N edge = N(limit) * sum;
        return sign_of(N(square_distance - edge * edge)) < 0;
    };
    Found<N> found;
    found.side = above >= 0 ? +1 : -1;
    if (nearer(above >= 0 ? query.gap : query.depth))
        found.kind = Kind::contact;
    else if (above >= 0 && nearer(query.proximity_reach))
        found.kind = Kind::proximity;
    else
        return {};
    const N three(3);
    const N two(2);
    found.size =
        size_of(N(scale - three * b)) + size_of(N(scale - three * c)) + size_of(N(two * scale - three * b - three * c));
    found.scale = scale;
    return found;
}

template <class N>
Found<N> found_on(const DecisionTool& tool, const ContactQuery& query, int segment, int k) {
    const auto& rank = tool.segment[static_cast<size_t>(segment)];
    const auto corner = [&](int j) {
        const size_t i = static_cast<size_t>(rank[static_cast<size_t>(j)]);
        return Corner<N>{taken<N>(tool.node[i]), taken<N>(tool.normal[i])};
    };
    if (rank[2] == rank[3]) return found_on<N>(taken<N>(query.point), {corner(2), corner(0), corner(1)}, query);
    Corner<N> centre;
    const N quarter(0.25);
    for (size_t i = 0; i < 3; ++i) {
        N place(0);
        N normal(0);
        for (int j = 0; j < 4; ++j) {
            place = place + corner(j).place[i];
            normal = normal + corner(j).normal[i];
        }
        centre.place[i] = place * quarter;
        centre.normal[i] = normal * quarter;
    }
    return found_on<N>(taken<N>(query.point), {centre, corner(k - 1), corner(k % 4)}, query);
}

/// A sub-triangle that takes the node, by intervals where they can tell.
class Candidate {
  public:
    Candidate(const DecisionTool& tool, const ContactQuery& query, int segment, int k)
        : tool_(&tool), query_(&query), segment_(segment), triangle_(k) {
        try {
            rough_ = found_on<Interval>(tool, query, segment, k);
            kind_ = rough_->kind;
            side_ = rough_->side;
        } catch (const Uncertain&) {
            kind_ = exact().kind;
            side_ = exact().side;
        }
    }

    const Found<Exact>& exact() {
        if (!exact_) exact_ = found_on<Exact>(*tool_, *query_, segment_, triangle_);
        return *exact_;
    }

    Kind kind() const { return kind_; }
    bool by_intervals() const { return !exact_; }

    /// Contact, then the smaller kappa, then the lower segment, then the lower k.
    bool wins_against(Candidate& other) {
        if (kind_ != other.kind_) return kind_ == Kind::contact;
        const int order = compared_with(other);
        if (order != 0) return order < 0;
        return segment_ != other.segment_ ? segment_ < other.segment_ : triangle_ < other.triangle_;
    }

    DecisionAnswer answer() const { return {kind_, segment_, triangle_, side_, Stage::interval, 0, 0}; }

  private:
    /// Sign of kappa - other kappa.
    int compared_with(Candidate& other) {
        if (rough_ && other.rough_) try {
                return sign_of(rough_->size * other.rough_->scale - other.rough_->size * rough_->scale);
            } catch (const Uncertain&) {
            }
        return sign_of(Exact(exact().size * other.exact().scale - other.exact().size * exact().scale));
    }

    const DecisionTool* tool_;
    const ContactQuery* query_;
    int segment_, triangle_;
    Kind kind_ = Kind::none;
    int side_ = 0;
    std::optional<Found<Interval>> rough_;
    std::optional<Found<Exact>> exact_;
};

/// True where the node is certainly no nearer to the box of a segment than the farthest reach: what is retained is
/// nearer than that to a point of the segment.
bool out_of_reach(const DecisionTool& tool, const ContactQuery& query, int segment) {
    Interval square(0.0);
    for (int i = 0; i < 3; ++i) {
        double low = HUGE_VAL;
        double high = -HUGE_VAL;
        for (const int j : tool.segment[static_cast<size_t>(segment)]) {
            low = std::min(low, tool.node[static_cast<size_t>(j)][i]);
            high = std::max(high, tool.node[static_cast<size_t>(j)][i]);
        }
        const double x = query.point[i];
        if (x < low) square += CGAL::square(Interval(low) - Interval(x));
        if (x > high) square += CGAL::square(Interval(x) - Interval(high));
    }
    const Interval farthest(std::max({query.gap, query.depth, query.proximity_reach}));
    return square.inf() > 0 && square.inf() >= (farthest * farthest).sup();
}

}  // namespace

DecisionAnswer second_opinion(const DecisionTool& tool, const ContactQuery& query) {
    if (!query.as_documented()) throw std::invalid_argument("the second opinion knows the documented limits only");
    const Interval::Protector upward;
    std::optional<Candidate> best;
    bool by_intervals = true;
    for (int s = 0; s < static_cast<int>(tool.segment.size()); ++s) {
        if (out_of_reach(tool, query, s)) continue;
        const auto& rank = tool.segment[static_cast<size_t>(s)];
        const int pieces = rank[2] == rank[3] ? 1 : 4;
        for (int k = 1; k <= pieces; ++k) {
            Candidate one(tool, query, s, k);
            const bool wins = one.kind() != Kind::none && (!best || one.wins_against(*best));
            by_intervals = by_intervals && one.by_intervals() && (!best || best->by_intervals());
            if (wins) best.emplace(std::move(one));
        }
    }
    DecisionAnswer answer = best ? best->answer() : DecisionAnswer{};
    answer.stage = by_intervals ? Stage::interval : Stage::exact;
    return answer;
}

}  // namespace type21
