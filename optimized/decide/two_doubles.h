/// @file Numbers of about 100 bits: an unevaluated sum of two doubles.
#pragma once

#include <cmath>

namespace type21::optimized {

/// high + low, |low| <= ulp(high) / 2. Sums, products and quotients are right to 2^-100 of themselves as long as
/// nothing overflows or underflows (bounds 3 u^2, 7 u^2 and 15 u^2, u = 2^-53, of Joldes, Muller and Popescu, Tight and
/// rigorous error bounds for basic building blocks of double-word arithmetic, 2017).
struct TwoDoubles {
    double high = 0, low = 0;

    TwoDoubles() = default;
    TwoDoubles(double value) : high(value) {}  // NOLINT: a double is one
    TwoDoubles(double high_, double low_) : high(high_), low(low_) {}

    /// s + t exactly, |s| >= |t|.
    static TwoDoubles quick_sum(double s, double t) {
        const double sum = s + t;
        return {sum, t - (sum - s)};
    }
    /// s + t exactly.
    static TwoDoubles exact_sum(double s, double t) {
        const double sum = s + t;
        const double of_t = sum - s;
        return {sum, (s - (sum - of_t)) + (t - of_t)};
    }
    /// s * t exactly (Dekker): halves of 26 bits.
    static TwoDoubles exact_product(double s, double t) {
        constexpr double splitter = 134217729;  // 2^27 + 1
        const double product = s * t;
        const double cs = splitter * s, ct = splitter * t;
        const double sh = cs - (cs - s), th = ct - (ct - t);
        const double sl = s - sh, tl = t - th;
        return {product, ((sh * th - product) + sh * tl + sl * th) + sl * tl};
    }

    friend TwoDoubles operator+(const TwoDoubles& x, const TwoDoubles& y) {
        const TwoDoubles s = exact_sum(x.high, y.high), t = exact_sum(x.low, y.low);
        const TwoDoubles v = quick_sum(s.high, s.low + t.high);
        return quick_sum(v.high, t.low + v.low);
    }
    friend TwoDoubles operator-(const TwoDoubles& x) { return {-x.high, -x.low}; }
    friend TwoDoubles operator-(const TwoDoubles& x, const TwoDoubles& y) { return x + -y; }
    friend TwoDoubles operator*(const TwoDoubles& x, const TwoDoubles& y) {
        const TwoDoubles p = exact_product(x.high, y.high);
        return quick_sum(p.high, p.low + (x.high * y.low + x.low * y.high));
    }
    friend TwoDoubles operator/(const TwoDoubles& x, const TwoDoubles& y) {
        const double quotient = x.high / y.high;
        const TwoDoubles left = x - y * TwoDoubles(quotient);
        const double more = left.high / y.high;
        const TwoDoubles left2 = left - y * TwoDoubles(more);
        return TwoDoubles(quick_sum(quotient, more)) + TwoDoubles(left2.high / y.high);
    }
    friend bool operator<(const TwoDoubles& x, const TwoDoubles& y) { return (x - y).high < 0; }
    friend bool operator>(const TwoDoubles& x, const TwoDoubles& y) { return y < x; }
};

/// The double nearest to a number.
inline double leading(double v) {
    return v;
}
inline double leading(const TwoDoubles& v) {
    return v.high;
}
inline TwoDoubles magnitude(const TwoDoubles& v) {
    return v.high < 0 ? -v : v;
}
inline double magnitude(double v) {
    return std::abs(v);
}

/// Largest relative error of one operation, and 1/3 to that error.
template <class Real>
struct Rounding;
template <>
struct Rounding<double> {
    static constexpr double unit = 0x1p-53;
    static double third() { return 1.0 / 3; }
    static double exact_product(double s, double t) { return s * t; }
};
template <>
struct Rounding<TwoDoubles> {
    static constexpr double unit = 0x1p-100;
    static TwoDoubles third() { return TwoDoubles(1) / TwoDoubles(3); }
    static TwoDoubles exact_product(double s, double t) { return TwoDoubles::exact_product(s, t); }
};

}  // namespace type21::optimized
