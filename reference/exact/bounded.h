/// @file First stage: a double with a bound on the distance to the real number that it stands for.
#pragma once

#include <cfloat>
#include <cmath>

#include "reference/exact/eigen_traits.h"
#include "reference/exact/undecided.h"

namespace type21::reference {

/// A double and a bound of its error: the real number lies within error() of value().
///
/// With u = 2^-53 and * one of the four operations, fl(a * b) = (a * b)(1 + d) + e, |d| <= u, and e = 0 or, where a
/// product or quotient underflows, |e| <= 2^-1075; so for operands a, b with errors r, s
///   a + b: r + s + u |a + b|        a b: |a| s + |b| r + r s + u |a b| + w        a / b: (r + |a/b| s) / (|b| - s) + u
///   |a/b| + w
/// with w = 2^-1022 >= 2^-1075. The bound itself is computed with fewer than eight roundings, which the factor 1 + 16 u
/// covers. An overflow makes bound or value infinite or not a number, and no comparison holds then: it is undecided.
class Bounded {
  public:
    Bounded() = default;
    explicit Bounded(double exact) : value_(exact) {}

    double value() const { return value_; }
    double error() const { return error_; }

    friend Bounded operator+(const Bounded& a, const Bounded& b) {
        const double sum = a.value_ + b.value_;
        return {sum, a.error_ + b.error_ + unit * std::abs(sum)};
    }
    friend Bounded operator-(const Bounded& a, const Bounded& b) {
        const double difference = a.value_ - b.value_;
        return {difference, a.error_ + b.error_ + unit * std::abs(difference)};
    }
    friend Bounded operator*(const Bounded& a, const Bounded& b) {
        if (a.exact_zero() || b.exact_zero()) return Bounded(0.0);
        const double product = a.value_ * b.value_;
        return {product, std::abs(a.value_) * b.error_ + std::abs(b.value_) * a.error_ + a.error_ * b.error_ +
                             unit * std::abs(product) + tiny};
    }
    friend Bounded operator/(const Bounded& a, const Bounded& b) {
        const double away = std::abs(b.value_) - b.error_;
        if (!(away > 0)) throw Undecided();  // the divisor may be zero
        if (a.exact_zero()) return Bounded(0.0);
        const double quotient = a.value_ / b.value_;
        return {quotient, (a.error_ + std::abs(quotient) * b.error_) / away + unit * std::abs(quotient) + tiny};
    }
    friend Bounded operator-(const Bounded& a) {
        Bounded negative;
        negative.value_ = -a.value_;
        negative.error_ = a.error_;
        return negative;
    }
    Bounded& operator+=(const Bounded& b) { return *this = *this + b; }
    Bounded& operator-=(const Bounded& b) { return *this = *this - b; }
    Bounded& operator*=(const Bounded& b) { return *this = *this * b; }
    Bounded& operator/=(const Bounded& b) { return *this = *this / b; }

    friend bool operator<(const Bounded& a, const Bounded& b) { return (b - a).sign() > 0; }
    friend bool operator>(const Bounded& a, const Bounded& b) { return (a - b).sign() > 0; }
    friend bool operator==(const Bounded& a, const Bounded& b) { return (a - b).sign() == 0; }
    friend bool operator!=(const Bounded& a, const Bounded& b) { return !(a == b); }

    /// @throws Undecided
    int sign() const {
        if (value_ > error_) return 1;
        if (value_ < -error_) return -1;
        if (exact_zero()) return 0;
        throw Undecided();
    }

    friend Bounded magnitude(const Bounded& a) { return a.value_ < 0 ? -a : a; }
    /// Clipping moves no two numbers apart, so the bound stays.
    friend Bounded clipped(const Bounded& a) {
        Bounded result = a;
        if (a.value_ < 0) result.value_ = 0;
        if (a.value_ > 1) result.value_ = 1;
        return result;
    }

  private:
    static constexpr double unit = DBL_EPSILON / 2;
    static constexpr double tiny = DBL_MIN;

    Bounded(double value, double error) : value_(value), error_(error * (1 + 16 * unit)) {}
    bool exact_zero() const { return value_ == 0 && error_ == 0; }

    double value_ = 0;
    double error_ = 0;
};

}  // namespace type21::reference

namespace Eigen {
template <>
struct NumTraits<type21::reference::Bounded> : type21::reference::FieldTraits<type21::reference::Bounded> {};
}  // namespace Eigen
