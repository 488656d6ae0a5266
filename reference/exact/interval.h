/// @file Second stage: intervals of doubles that contain the exact number (Formulation 10, step 4).
#pragma once

#include <algorithm>

#include <CGAL/Interval_nt.h>

#include "reference/exact/eigen_traits.h"
#include "reference/exact/undecided.h"

namespace type21::reference {

/// CGAL's interval arithmetic with comparisons that give a certain answer or throw Undecided. It needs the rounding
/// mode that Interval::Upward sets. An interval stays a point while its operations are exact. So this stage also
/// decides ties of nodes and tools whose coordinates are small multiples of a power of two.
class Interval {
  public:
    using Bounds = CGAL::Interval_nt<false>;
    using Upward = Bounds::Protector;  ///< rounds upwards while it lives; then the former mode is restored

    Interval() : bounds_(0.0) {}
    explicit Interval(double exact) : bounds_(exact) {}

    double low() const { return bounds_.inf(); }
    double high() const { return bounds_.sup(); }

    friend Interval operator+(const Interval& a, const Interval& b) { return Interval(a.bounds_ + b.bounds_); }
    friend Interval operator-(const Interval& a, const Interval& b) { return Interval(a.bounds_ - b.bounds_); }
    friend Interval operator*(const Interval& a, const Interval& b) { return Interval(a.bounds_ * b.bounds_); }
    friend Interval operator/(const Interval& a, const Interval& b) { return Interval(a.bounds_ / b.bounds_); }
    friend Interval operator-(const Interval& a) { return Interval(-a.bounds_); }
    Interval& operator+=(const Interval& b) { return *this = *this + b; }
    Interval& operator-=(const Interval& b) { return *this = *this - b; }
    Interval& operator*=(const Interval& b) { return *this = *this * b; }
    Interval& operator/=(const Interval& b) { return *this = *this / b; }

    friend bool operator<(const Interval& a, const Interval& b) { return certain(a.bounds_ < b.bounds_); }
    friend bool operator>(const Interval& a, const Interval& b) { return certain(a.bounds_ > b.bounds_); }
    friend bool operator==(const Interval& a, const Interval& b) { return certain(a.bounds_ == b.bounds_); }
    friend bool operator!=(const Interval& a, const Interval& b) { return certain(a.bounds_ != b.bounds_); }

    friend Interval magnitude(const Interval& a) { return Interval(CGAL::abs(a.bounds_)); }
    friend Interval clipped(const Interval& a) {
        return Interval(Bounds(std::clamp(a.low(), 0.0, 1.0), std::clamp(a.high(), 0.0, 1.0)));
    }

  private:
    explicit Interval(const Bounds& bounds) : bounds_(bounds) {}
    static bool certain(CGAL::Uncertain<bool> answer) {
        if (!answer.is_certain()) throw Undecided();
        return answer.make_certain();
    }

    Bounds bounds_;
};

}  // namespace type21::reference

namespace Eigen {
template <>
struct NumTraits<type21::reference::Interval> : type21::reference::FieldTraits<type21::reference::Interval> {};
}  // namespace Eigen
