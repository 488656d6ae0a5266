/// @file First stage: a double with a bound on its distance to the exact number (Formulation 10, step 3).
#pragma once

#include <cfloat>
#include <cmath>

#include "reference/exact/eigen_traits.h"
#include "reference/exact/undecided.h"

namespace type21::reference {

/// A double and a bound on its error: the exact number lies within error() of value(). The unit is that of the number.
///
/// Rounding: for each of the four operations, fl(a op b) = (a op b)(1 + d) + e with |d| <= u = 2^-53. Here e = 0, or
/// |e| <= 2^-1075 where a product or quotient underflows. For operands a, b with error bounds r, s this gives
///   a + b:  r + s + u |a + b|
///   a b:    |a| s + |b| r + r s + u |a b| + w
///   a / b:  (r + |a/b| s) / (|b| - s) + u |a/b| + w
/// with w = 2^-1022 >= 2^-1075. The bound itself is computed with fewer than eight roundings; the factor 1 + 16 u
/// covers them. An overflow makes the value or the bound infinite or NaN; then no comparison is certain.
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

    /// Sign of the exact number: -1, 0 or +1.
    /// @throws Undecided where the bound allows more than one
    int sign() const {
        if (value_ > error_) return 1;
        if (value_ < -error_) return -1;
        if (exact_zero()) return 0;
        throw Undecided();
    }

    friend Bounded magnitude(const Bounded& a) { return a.value_ < 0 ? -a : a; }
    /// Clipped to [0, 1]. Clipping never increases the distance of two numbers, so the bound stays valid.
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
