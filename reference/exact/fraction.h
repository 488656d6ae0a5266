/// @file Third stage: rational numbers, without rounding (Formulation 10, step 5).
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <CGAL/Mpzf.h>

#include "reference/exact/eigen_traits.h"

namespace type21::reference {

/// An exact rational number, stored as integer * f1^e1 * f2^e2 * ... with positive or negative exponents.
///
/// The formulation divides by few numbers, and all later numbers have the same denominators, which may have thousands
/// of digits. An ordinary rational number searches for common divisors after every operation, and that is nearly all of
/// its cost. Here each divisor becomes a factor that all its quotients share. A product adds exponents; a sum brings
/// both terms to the lower exponent of each factor. No common divisor is ever searched. The "integers" are CGAL's exact
/// dyadic numbers m 2^e (CGAL::Mpzf).
class Fraction {
  public:
    using Integer = CGAL::Mpzf;

    Fraction() = default;
    Fraction(double value) : integer_(value) {}  // NOLINT(google-explicit-constructor): a double is a fraction
    Fraction(int value) : integer_(value) {}     // NOLINT(google-explicit-constructor)

    int sign() const;          ///< -1, 0 or +1
    double to_double() const;  ///< the middle of enclosure()
    /// Lower and upper bound; at most an ulp apart where a double can represent the size of the number.
    std::pair<double, double> enclosure() const;

    friend Fraction operator+(const Fraction& a, const Fraction& b) { return sum(a, b, +1); }
    friend Fraction operator-(const Fraction& a, const Fraction& b) { return sum(a, b, -1); }
    friend Fraction operator*(const Fraction& a, const Fraction& b);
    /// @throws std::domain_error when b is zero
    friend Fraction operator/(const Fraction& a, const Fraction& b);
    friend Fraction operator-(const Fraction& a);
    Fraction& operator+=(const Fraction& b) { return *this = *this + b; }
    Fraction& operator-=(const Fraction& b) { return *this = *this - b; }
    Fraction& operator*=(const Fraction& b) { return *this = *this * b; }
    Fraction& operator/=(const Fraction& b) { return *this = *this / b; }

    friend bool operator<(const Fraction& a, const Fraction& b) { return (a - b).sign() < 0; }
    friend bool operator>(const Fraction& a, const Fraction& b) { return (a - b).sign() > 0; }
    friend bool operator==(const Fraction& a, const Fraction& b) { return (a - b).sign() == 0; }
    friend bool operator!=(const Fraction& a, const Fraction& b) { return !(a == b); }

  private:
    struct Factor {
        Integer value;
        long rank;  ///< the order in which factors were made; lists are merged by it
    };
    struct Power {
        std::shared_ptr<const Factor> factor;
        int exponent;  ///< not 0
    };
    using Powers = std::vector<Power>;  ///< by ascending rank of the factor

    static Fraction sum(const Fraction& a, const Fraction& b, int sign);
    /// The powers of both, combined factor by factor; an absent factor has the exponent 0.
    template <class Combine>
    static Powers merge(const Powers& a, const Powers& b, Combine combine);
    /// The integer with the powers multiplied in; the exponents must not be negative.
    static Integer multiplied(Integer integer, const Powers& powers);
    const std::shared_ptr<const Factor>& as_factor() const;

    Integer integer_ = 0;
    Powers powers_;
    mutable std::shared_ptr<const Factor> as_factor_;  ///< the integer, once it has divided something
};

}  // namespace type21::reference

namespace Eigen {
template <>
struct NumTraits<type21::reference::Fraction> : type21::reference::FieldTraits<type21::reference::Fraction> {};
}  // namespace Eigen
