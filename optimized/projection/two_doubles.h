/// @file Double-double: numbers of about 100 bits, the unevaluated sum of two doubles.
#pragma once

#include <cmath>

#include "optimized/simd/simd_width.h"

namespace type21::optimized {

/// high + low, |low| <= ulp(high) / 2. Sums, products and quotients are right to 2^-100 = 64 u^2 of themselves, u =
/// 2^-53, as long as nothing overflows or underflows: the sum to 3 u^2 / (1 - 4 u) (algorithm 6, AccurateDWPlusDW), the
/// product to 7 u^2 (algorithm 10, DWTimesDW1), the quotient to less than the 15 u^2 of algorithm 17 (DWDivDW2), since
/// it has one correction more. Source: M. Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic
/// building blocks of double-word arithmetic, ACM Transactions on Mathematical Software 44 (2), 2017. Exact sums and
/// products: T. J. Dekker, A floating-point technique for extending the available precision, Numerische Mathematik 18,
/// 1971.
/// @tparam fused  exact products by a fused multiply-add; the same numbers
template <bool fused>
struct TwoDoublesOf {
    double high = 0, low = 0;

    TwoDoublesOf() = default;
    TYPE21_INLINE TwoDoublesOf(double value) : high(value) {}  // NOLINT: a double is one
    TYPE21_INLINE TwoDoublesOf(double high_, double low_) : high(high_), low(low_) {}

    /// s + t exactly, |s| >= |t|.
    static TYPE21_INLINE TwoDoublesOf quick_sum(double s, double t) {
        const double sum = s + t;
        return {sum, t - (sum - s)};
    }
    /// s + t exactly.
    static TYPE21_INLINE TwoDoublesOf exact_sum(double s, double t) {
        const double sum = s + t;
        const double of_t = sum - s;
        return {sum, (s - (sum - of_t)) + (t - of_t)};
    }
    /// s * t exactly; without a fused multiply-add by halves of 26 bits.
    static TYPE21_INLINE TwoDoublesOf exact_product(double s, double t) {
        const double product = s * t;
        if constexpr (fused) return {product, __builtin_fma(s, t, -product)};
        constexpr double splitter = 134217729;  // 2^27 + 1
        const double cs = splitter * s, ct = splitter * t;
        const double sh = cs - (cs - s), th = ct - (ct - t);
        const double sl = s - sh, tl = t - th;
        return {product, ((sh * th - product) + sh * tl + sl * th) + sl * tl};
    }

    friend TYPE21_INLINE TwoDoublesOf operator+(const TwoDoublesOf& x, const TwoDoublesOf& y) {
        const TwoDoublesOf s = exact_sum(x.high, y.high), t = exact_sum(x.low, y.low);
        const TwoDoublesOf v = quick_sum(s.high, s.low + t.high);
        return quick_sum(v.high, t.low + v.low);
    }
    friend TYPE21_INLINE TwoDoublesOf operator-(const TwoDoublesOf& x) { return {-x.high, -x.low}; }
    friend TYPE21_INLINE TwoDoublesOf operator-(const TwoDoublesOf& x, const TwoDoublesOf& y) { return x + -y; }
    friend TYPE21_INLINE TwoDoublesOf operator*(const TwoDoublesOf& x, const TwoDoublesOf& y) {
        const TwoDoublesOf p = exact_product(x.high, y.high);
        return quick_sum(p.high, p.low + (x.high * y.low + x.low * y.high));
    }
    friend TYPE21_INLINE TwoDoublesOf operator/(const TwoDoublesOf& x, const TwoDoublesOf& y) {
        const double quotient = x.high / y.high;
        const TwoDoublesOf left = x - y * TwoDoublesOf(quotient);
        const double more = left.high / y.high;
        const TwoDoublesOf left2 = left - y * TwoDoublesOf(more);
        return TwoDoublesOf(quick_sum(quotient, more)) + TwoDoublesOf(left2.high / y.high);
    }
    friend TYPE21_INLINE bool operator<(const TwoDoublesOf& x, const TwoDoublesOf& y) { return (x - y).high < 0; }
    friend TYPE21_INLINE bool operator>(const TwoDoublesOf& x, const TwoDoublesOf& y) { return y < x; }
};
using TwoDoubles = TwoDoublesOf<false>;

/// The double nearest to a number.
TYPE21_INLINE double leading(double v) {
    return v;
}
template <bool fused>
TYPE21_INLINE double leading(const TwoDoublesOf<fused>& v) {
    return v.high;
}
template <bool fused>
TYPE21_INLINE TwoDoublesOf<fused> magnitude(const TwoDoublesOf<fused>& v) {
    return v.high < 0 ? -v : v;
}
TYPE21_INLINE double magnitude(double v) {
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
template <bool fused>
struct Rounding<TwoDoublesOf<fused>> {
    using Real = TwoDoublesOf<fused>;
    static constexpr double unit = 0x1p-100;
    static TYPE21_INLINE Real third() { return Real(1) / Real(3); }
    static TYPE21_INLINE Real exact_product(double s, double t) { return Real::exact_product(s, t); }
};

}  // namespace type21::optimized
