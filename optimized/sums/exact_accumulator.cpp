#include "optimized/sums/exact_accumulator.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "optimized/machine.h"

namespace type21::optimized {

namespace {

constexpr std::int64_t base = std::int64_t{1} << 32;

constexpr int lanes = 8;
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

TYPE21_INLINE void load(const double* from, Lanes& to) {
    __builtin_memcpy(&to, from, sizeof(to));
}
TYPE21_INLINE void magnitude_of(Lanes& v) {
    v = v < 0 ? -v : v;
}

/// Largest magnitude of whole groups of lanes.
TYPE21_FOR_EACH_MACHINE
double largest_magnitude(const double* value, int groups) {
    Lanes most = {};
    for (int g = 0; g < groups; ++g) {
        Lanes v;
        load(value + g * lanes, v);
        magnitude_of(v);
        most = v > most ? v : most;
    }
    double largest = 0;
    for (int j = 0; j < lanes; ++j)
        largest = most[j] > largest ? most[j] : largest;
    return largest;
}

/// Cuts by adding and subtracting 1.5 * 2^(m + 52 - bits): what is left is the number rounded to a multiple of
/// 2^(m - bits). With |value| < 2^m, bits = 40, 80, 120 and at most 2048 numbers every sum below is a whole multiple of
/// its unit with at most 41 + 11 bits: exact.
/// @return 0 when nothing is left below the slices
TYPE21_FOR_EACH_MACHINE
double slice(const double* value, int groups, const double* cut, double* sum) {
    Lanes first = {}, second = {}, third = {}, rest = {};
    for (int g = 0; g < groups; ++g) {
        Lanes left, high;
        load(value + g * lanes, left);
        high = (left + cut[0]) - cut[0];
        first += high;
        left -= high;
        high = (left + cut[1]) - cut[1];
        second += high;
        left -= high;
        high = (left + cut[2]) - cut[2];
        third += high;
        left -= high;
        magnitude_of(left);
        rest += left;
    }
    double remaining = 0;
    for (int j = 0; j < lanes; ++j) {
        sum[0] += first[j];
        sum[1] += second[j];
        sum[2] += third[j];
        remaining += rest[j];
    }
    return remaining;
}

}  // namespace

void ExactAccumulator::add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int exponent = static_cast<int>(bits >> 52) & 2047;
    if (exponent == 2047) {
        not_finite_ += value;
        return;
    }
    std::uint64_t mantissa = bits & ((std::uint64_t{1} << 52) - 1);
    if (exponent != 0) mantissa |= std::uint64_t{1} << 52;
    const int place = exponent == 0 ? 0 : exponent - 1;
    const auto at = static_cast<size_t>(place) / 32;
    const int shift = place % 32;
    const std::uint64_t low = (mantissa << shift) & (static_cast<std::uint64_t>(base) - 1);
    const std::uint64_t above = mantissa >> (32 - shift);  // shift 0: mantissa >> 32
    const auto middle = static_cast<std::int64_t>(above & (static_cast<std::uint64_t>(base) - 1));
    const auto high = static_cast<std::int64_t>(above >> 32);
    if (std::signbit(value)) {
        digit_[at] -= static_cast<std::int64_t>(low);
        digit_[at + 1] -= middle;
        digit_[at + 2] -= high;
    } else {
        digit_[at] += static_cast<std::int64_t>(low);
        digit_[at + 1] += middle;
        digit_[at + 2] += high;
    }
    if (++additions_ >= most_additions) carry();
}

void ExactAccumulator::add_block(const double* value, int n) {
    const int groups = n / lanes, whole = groups * lanes;
    const double most = largest_magnitude(value, groups);
    double rest = 1;
    double sum[3] = {0, 0, 0};
    // NaN compares false everywhere: the rest tells.
    if ((most == 0 || (most > 0x1p-800 && most < 0x1p900)) && n <= 2048) {
        const int m = most == 0 ? 0 : std::ilogb(most) + 1;
        const double cut[3] = {std::ldexp(1.5, m + 12), std::ldexp(1.5, m - 28), std::ldexp(1.5, m - 68)};
        rest = slice(value, groups, cut, sum);
    }
    const bool sliced = rest == 0;
    if (sliced) {
        for (const double s : sum)
            add(s);
    }
    for (int j = sliced ? whole : 0; j < n; ++j)
        add(value[j]);
}

void ExactAccumulator::carry() {
    for (size_t i = 0; i + 1 < digit_.size(); ++i) {
        // Floor division leaves digits in [0, 2^32); the last keeps the sign.
        const std::int64_t up = digit_[i] >> 32;
        digit_[i] -= up * base;
        digit_[i + 1] += up;
    }
    additions_ = 2;
}

void ExactAccumulator::add(const ExactAccumulator& other) {
    ExactAccumulator carried = other;
    carried.carry();
    carry();
    for (size_t i = 0; i < digit_.size(); ++i)
        digit_[i] += carried.digit_[i];
    additions_ = 4;
    not_finite_ += other.not_finite_;
}

double ExactAccumulator::value() const {
    if (not_finite_ != 0) return not_finite_;
    ExactAccumulator sum = *this;
    sum.carry();
    const bool negative = sum.digit_.back() < 0;
    if (negative) {
        for (std::int64_t& digit : sum.digit_)
            digit = -digit;
        sum.carry();
    }
    int top = digits - 1;
    while (top >= 0 && sum.digit_[static_cast<size_t>(top)] == 0)
        --top;
    if (top < 0) return 0;
    // The leading bits as a whole number, with one more bit that says whether anything lies below.
    const auto digit = [&](int i) {
        return i < 0 ? std::uint64_t{0} : static_cast<std::uint64_t>(sum.digit_[static_cast<size_t>(i)]);
    };
    const int length = 64 - std::countl_zero(digit(top));
    const int last = 32 * top + length - 1;    // place of the leading bit
    const int first = std::max(last - 52, 0);  // place of the last bit that a double holds
    const auto bit = [&](int place) { return place >= 0 && ((digit(place / 32) >> (place % 32)) & 1) != 0; };
    std::uint64_t mantissa = 0;
    for (int place = last; place >= first; --place)
        mantissa = 2 * mantissa + (bit(place) ? 1 : 0);
    if (bit(first - 1)) {
        bool more = (mantissa & 1) != 0;
        for (int place = first - 2; place >= 0 && !more; --place)
            more = bit(place);
        if (more) ++mantissa;
    }
    const double size = std::ldexp(static_cast<double>(mantissa), first - 1074);
    return negative ? -size : size;
}

}  // namespace type21::optimized
