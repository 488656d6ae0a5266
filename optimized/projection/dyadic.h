/// @file Doubles as integers times one power of two.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <gmpxx.h>
#include <limits>

#include "optimized/projection/vector3.h"

namespace type21::optimized {

/// value = mantissa * 2^exponent, mantissa odd or 0.
struct Dyadic {
    std::int64_t mantissa = 0;
    int exponent = 0;
};

inline Dyadic dyadic(double value) {
    if (value == 0) return {};
    int exponent = 0;
    auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    const int zeros = __builtin_ctzll(static_cast<unsigned long long>(std::llabs(mantissa)));
    return {mantissa / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

inline mpz_class shifted(const mpz_class& value, int bits) {
    mpz_class result;
    mpz_mul_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(bits));
    return result;
}

/// The smallest exponent among the numbers it has seen, so that all of them are integer multiples of 2^exponent.
class CommonExponent {
  public:
    void see(double value) {
        if (value != 0) exponent_ = std::min(exponent_, dyadic(value).exponent);
    }
    void see(const V3& v) {
        see(v.x);
        see(v.y);
        see(v.z);
    }
    void at_most(int exponent) { exponent_ = std::min(exponent_, exponent); }
    int value() const { return exponent_ == std::numeric_limits<int>::max() ? 0 : exponent_; }

    /// value / 2^exponent
    mpz_class integer(double value) const {
        const Dyadic d = dyadic(value);
        if (d.mantissa == 0) return 0;
        static_assert(sizeof(long) == sizeof(std::int64_t));
        return shifted(mpz_class(static_cast<long>(d.mantissa)), d.exponent - this->value());
    }

  private:
    int exponent_ = std::numeric_limits<int>::max();
};

/// over * 2^exponent / under, to a few units in the last place. under > 0.
inline double quotient(const mpz_class& over, const mpz_class& under, int exponent = 0) {
    const int sign = sgn(over);
    if (sign == 0) return 0;
    const auto bits = [](const mpz_class& v) { return static_cast<long>(mpz_sizeinbase(v.get_mpz_t(), 2)); };
    const long shift = 66 - (bits(over) - bits(under));
    mpz_class scaled;
    if (shift >= 0) {
        mpz_mul_2exp(scaled.get_mpz_t(), over.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
        mpz_tdiv_q(scaled.get_mpz_t(), scaled.get_mpz_t(), under.get_mpz_t());
    } else {
        mpz_class divisor;
        mpz_mul_2exp(divisor.get_mpz_t(), under.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
        mpz_tdiv_q(scaled.get_mpz_t(), over.get_mpz_t(), divisor.get_mpz_t());
    }
    long binary = 0;
    const double mantissa = mpz_get_d_2exp(&binary, scaled.get_mpz_t());
    return std::ldexp(mantissa, static_cast<int>(binary - shift) + exponent);
}

}  // namespace type21::optimized
