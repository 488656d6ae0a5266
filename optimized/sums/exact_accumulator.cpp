#include "optimized/sums/exact_accumulator.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace type21::optimized {

namespace {

constexpr std::int64_t base = std::int64_t{1} << 32;

constexpr int lanes = 8;

/// Cuts by adding and subtracting 1.5 * 2^(m + 52 - bits): what is left is the number rounded to a multiple of
/// 2^(m - bits). With |value| < 2^m, bits = 40, 80, 120 and at most 2048 numbers every sum below is a whole multiple of
/// its unit with at most 41 + 11 bits: exact.
double slice(const double* value, int n, const double (&cut)[3], double (&sum)[3]) {
    double part[3][lanes] = {};
    double rest[lanes] = {};
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        for (int j = 0; j < lanes; ++j) {
            double left = value[i + j];
            for (int s = 0; s < 3; ++s) {
                const double high = (left + cut[s]) - cut[s];
                part[s][j] += high;
                left -= high;
            }
            rest[j] += std::abs(left);
        }
    }
    for (int j = 0; i < n; ++i, ++j) {
        double left = value[i];
        for (int s = 0; s < 3; ++s) {
            const double high = (left + cut[s]) - cut[s];
            part[s][j] += high;
            left -= high;
        }
        rest[j] += std::abs(left);
    }
    double remaining = 0;
    for (int j = 0; j < lanes; ++j) {
        for (int s = 0; s < 3; ++s)
            sum[s] += part[s][j];
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
    double largest[lanes] = {};
    int i = 0;
    for (; i + lanes <= n; i += lanes)
        for (int j = 0; j < lanes; ++j)
            largest[j] = std::abs(value[i + j]) > largest[j] ? std::abs(value[i + j]) : largest[j];
    double most = 0;
    for (const double l : largest)
        most = std::max(most, l);
    for (; i < n; ++i)
        most = std::max(most, std::abs(value[i]));
    // NaN compares false everywhere: the sum below tells.
    if (!(most > 0x1p-800 && most < 0x1p900) || n < lanes || n > 2048) {
        for (int j = 0; j < n; ++j)
            add(value[j]);
        return;
    }
    const int m = std::ilogb(most) + 1;
    const double cut[3] = {std::ldexp(1.5, m + 12), std::ldexp(1.5, m - 28), std::ldexp(1.5, m - 68)};
    double sum[3] = {0, 0, 0};
    const double rest = slice(value, n, cut, sum);
    if (rest != 0) {  // also when NaN
        for (int j = 0; j < n; ++j)
            add(value[j]);
        return;
    }
    for (const double s : sum)
        add(s);
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
