// How close a decision was: the chain of projection.h with derivatives by the node's position.
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
    friend bool operator!=(const Sensitive& a, const Sensitive& b) { return !(a == b); }

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

/// An impact with the distance to where it would be of another kind, or none.
struct Standing {
    Impact<Sensitive> impact;
    double margin = infinity;
};

Standing standing_on(const DecisionInput& input, const Vector<Sensitive>& p, const SegmentShape<Sensitive>& shape,
                     int segment, int k) {
    Sensitive::nearest = infinity;
    Standing standing;
    const auto t = sub_triangle(shape, k);
    const ProjectionLimits<Sensitive> limits{Sensitive(input.limits.low), Sensitive(input.limits.high),
                                             input.limits.lift_leaning};
    if (const auto projection = project(p, t, limits)) {
        const auto near = approach(p, t, projection->weights);
        const ContactReach<Sensitive> reach{Sensitive(input.reach.gap), Sensitive(input.reach.depth),
                                            Sensitive(input.reach.proximity)};
        standing.margin = Sensitive::nearest;
        const Sensitive distance = root(near.squared_distance);
        const auto border = [&](double limit) {
            standing.margin = std::min(standing.margin, (distance - Sensitive(limit)).distance_to_zero());
        };
        border(near.side > 0 ? input.reach.gap : input.reach.depth);
        if (near.side > 0 && input.reach.proximity > input.reach.gap) border(input.reach.proximity);
        const Kind kind = classify(near, reach);
        if (kind != Kind::none)
            standing.impact = {kind, segment, k, near.side, *projection, centrality(projection->weights)};
        return standing;
    }
    standing.margin = Sensitive::nearest;
    return standing;
}

/// The largest power of two that is no larger than the largest coordinate of the node and the candidates; 1 for none.
double size_of(const DecisionInput& input) {
    double largest = input.point.cwiseAbs().maxCoeff();
    for (const int segment : input.segments)
        for (const Vec3& x : input.shape_of(segment).node)
            largest = std::max(largest, x.cwiseAbs().maxCoeff());
    // 2^1000 and its inverse are doubles, and so is what they scale.
    return largest > 0 ? std::ldexp(1.0, std::clamp(std::ilogb(largest), -1000, 1000)) : 1.0;
}

double margin_at_unit_size(const DecisionInput& input) {
    Vector<Sensitive> p;
    for (int i = 0; i < 3; ++i)
        p[i] = Sensitive(input.point[i], Vec3::Unit(i));
    std::vector<Standing> standings;
    for (const int segment : input.segments) {
        const SegmentShape<double> shape = input.shape_of(segment);
        const SegmentShape<Sensitive> fixed = constant(shape);
        for (int k = 1; k <= shape.sub_triangles(); ++k)
            standings.push_back(standing_on(input, p, fixed, segment, k));
    }
    const Standing* best = nullptr;
    for (const Standing& one : standings)
        if (best == nullptr || precedes(one.impact, best->impact, input.proximity_competes)) best = &one;
    double margin = infinity;
    for (const Standing& one : standings) {
        const bool races = &one != best && one.impact.kind != Kind::none &&
                           order_of_kinds(one.impact.kind, best->impact.kind, input.proximity_competes) == 0;
        const double own = races ? (one.impact.kappa - best->impact.kappa).distance_to_zero() : one.margin;
        margin = std::min(margin, own);
    }
    return margin;
}

}  // namespace

double decision_margin(const DecisionInput& input) {
    // Volumes and their squares must fit into doubles: the node is looked at in a unit of its own size.
    const double size = size_of(input);
    const ShapeOf shape_of = [&](int segment) {
        SegmentShape<double> shape = input.shape_of(segment);
        for (Vec3& x : shape.node)
            x /= size;
        return shape;
    };
    const ContactReach<double> reach{input.reach.gap / size, input.reach.depth / size, input.reach.proximity / size};
    return size * margin_at_unit_size(
                      {input.point / size, input.segments, shape_of, reach, input.limits, input.proximity_competes});
}

}  // namespace type21::reference
