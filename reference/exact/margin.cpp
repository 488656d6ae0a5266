// How close a decision was: projection.h computed with derivatives with respect to the position of the node.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/exact/eigen_traits.h"
#include "reference/exact/staged_impact.h"

namespace type21::reference {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A double with its gradient; each comparison records how far its outcome is from changing.
class Sensitive {
  public:
    Sensitive() = default;
    explicit Sensitive(double value) : value_(value) {}
    Sensitive(double value, const Vec3& gradient) : value_(value), gradient_(gradient) {}

    double value() const { return value_; }
    /// Distance to the nearest position where this number is zero, to first order.
    double distance_to_zero() const {
        const double steepness = gradient_.stableNorm();
        return steepness > 0 ? std::abs(value_) / steepness : infinity;
    }

    friend Sensitive operator+(const Sensitive& a, const Sensitive& b) {
        return {a.value_ + b.value_, a.gradient_ + b.gradient_};
    }
    friend Sensitive operator-(const Sensitive& a, const Sensitive& b) {
        return {a.value_ - b.value_, a.gradient_ - b.gradient_};
    }
    friend Sensitive operator*(const Sensitive& a, const Sensitive& b) {
        return {a.value_ * b.value_, a.gradient_ * b.value_ + b.gradient_ * a.value_};
    }
    friend Sensitive operator/(const Sensitive& a, const Sensitive& b) {
        const double quotient = a.value_ / b.value_;
        return {quotient, (a.gradient_ - b.gradient_ * quotient) / b.value_};
    }
    friend Sensitive operator-(const Sensitive& a) { return {-a.value_, -a.gradient_}; }
    Sensitive& operator+=(const Sensitive& b) { return *this = *this + b; }
    Sensitive& operator-=(const Sensitive& b) { return *this = *this - b; }
    Sensitive& operator*=(const Sensitive& b) { return *this = *this * b; }
    Sensitive& operator/=(const Sensitive& b) { return *this = *this / b; }

    friend bool operator<(const Sensitive& a, const Sensitive& b) { return (b - a).compared_to_zero() > 0; }
    friend bool operator>(const Sensitive& a, const Sensitive& b) { return (a - b).compared_to_zero() > 0; }
    friend bool operator==(const Sensitive& a, const Sensitive& b) { return (a - b).compared_to_zero() == 0; }

    friend Sensitive magnitude(const Sensitive& a) { return a.value_ < 0 ? -a : a; }
    friend Sensitive clipped(const Sensitive& a) {
        if (a.value_ < 0) return Sensitive(0.0);
        return a.value_ > 1 ? Sensitive(1.0) : a;
    }
    friend Sensitive root(const Sensitive& a) {
        const double value = std::sqrt(a.value_);
        // At zero distance the distance grows as fast as the node moves.
        if (value == 0) return {0.0, Vec3::UnitX()};
        return {value, a.gradient_ / (2 * value)};
    }

    static thread_local double nearest;  ///< smallest distance recorded

  private:
    double compared_to_zero() const {
        nearest = std::min(nearest, distance_to_zero());
        return value_;
    }

    double value_ = 0;
    Vec3 gradient_ = Vec3::Zero();
};

thread_local double Sensitive::nearest = infinity;

}  // namespace

}  // namespace type21::reference

namespace Eigen {
template <>
struct NumTraits<type21::reference::Sensitive> : type21::reference::FieldTraits<type21::reference::Sensitive> {};
}  // namespace Eigen

namespace type21::reference {

namespace {

Vector<Sensitive> constant(const Vec3& v) {
    return Vector<Sensitive>(Sensitive(v.x()), Sensitive(v.y()), Sensitive(v.z()));
}

SegmentShape<Sensitive> constant(const SegmentShape<double>& shape) {
    SegmentShape<Sensitive> same;
    for (size_t j = 0; j < 4; ++j) {
        same.node[j] = constant(shape.node[j]);
        same.normal[j] = constant(shape.normal[j]);
    }
    same.triangle = shape.triangle;
    return same;
}

/// An impact, and how far the node may move before it is of another kind or none [length].
struct Standing {
    Impact<Sensitive> impact;
    double margin = infinity;
};

Standing standing_on(const ContactQuery& query, const Vector<Sensitive>& p, const SegmentShape<Sensitive>& shape,
                     int segment, int k) {
    Sensitive::nearest = infinity;
    Standing standing;
    const auto t = sub_triangle(shape, k);
    if (const auto projection = project(p, t, limits_of<Sensitive>(query))) {
        const auto near = approach(p, t, projection->weights);
        standing.margin = Sensitive::nearest;
        const Sensitive distance = root(near.squared_distance);
        const auto border = [&](double limit) {
            standing.margin = std::min(standing.margin, (distance - Sensitive(limit)).distance_to_zero());
        };
        border(near.side > 0 ? query.gap : query.depth);
        if (near.side > 0 && query.proximity_reach > query.gap) border(query.proximity_reach);
        const Kind kind = classify(near, reach_of<Sensitive>(query));
        if (kind != Kind::none)
            standing.impact = {kind, segment, k, near.side, *projection, centrality(projection->weights)};
        return standing;
    }
    standing.margin = Sensitive::nearest;
    return standing;
}

/// The largest power of two that is no larger than the largest coordinate of the node and the candidates; 1 for none.
double size_of(const ContactQuery& query, const CandidateSegments& candidates) {
    double largest = query.point.cwiseAbs().maxCoeff();
    for (const int segment : candidates.ranks)
        for (const Vec3& x : candidates.shape_of(segment).node)
            largest = std::max(largest, x.cwiseAbs().maxCoeff());
    // 2^1000 and its inverse are doubles, and so is what they scale.
    return largest > 0 ? std::ldexp(1.0, std::clamp(std::ilogb(largest), -1000, 1000)) : 1.0;
}

double margin_at_unit_size(const ContactQuery& query, const CandidateSegments& candidates) {
    Vector<Sensitive> p;
    for (int i = 0; i < 3; ++i)
        p[i] = Sensitive(query.point[i], Vec3::Unit(i));
    std::vector<Standing> standings;
    for (const int segment : candidates.ranks) {
        const SegmentShape<double> shape = candidates.shape_of(segment);
        const SegmentShape<Sensitive> fixed = constant(shape);
        for (int k = 1; k <= shape.sub_triangles(); ++k)
            standings.push_back(standing_on(query, p, fixed, segment, k));
    }
    const Standing* best = nullptr;
    for (const Standing& one : standings)
        if (best == nullptr || precedes(one.impact, best->impact, query.proximity_competes)) best = &one;
    double margin = infinity;
    for (const Standing& one : standings) {
        const bool competes = &one != best && one.impact.kind != Kind::none &&
                              order_of_kinds(one.impact.kind, best->impact.kind, query.proximity_competes) == 0;
        const double own = competes ? (one.impact.kappa - best->impact.kappa).distance_to_zero() : one.margin;
        margin = std::min(margin, own);
    }
    return margin;
}

}  // namespace

double decision_margin(const ContactQuery& query, const CandidateSegments& candidates) {
    // Volumes and their squares must fit into doubles, so the lengths are scaled to about 1.
    const double size = size_of(query, candidates);
    const ShapeOf shape_of = [&](int segment) {
        SegmentShape<double> shape = candidates.shape_of(segment);
        for (Vec3& x : shape.node)
            x /= size;
        return shape;
    };
    ContactQuery scaled = query;
    scaled.point /= size;
    scaled.gap /= size;
    scaled.depth /= size;
    scaled.proximity_reach /= size;
    return size * margin_at_unit_size(scaled, {candidates.ranks, shape_of});
}

}  // namespace type21::reference
