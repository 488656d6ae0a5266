#include "optimized/sums/exact_accumulator.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "optimized/simd/lanes.h"

namespace type21::optimized {

namespace {

constexpr std::int64_t base = std::int64_t{1} << 32;

/// Largest magnitude of full groups of eight; NaN where one of them is NaN or infinite.
template <int W>
TYPE21_INLINE double largest_in(const double* value, int count) {
    Lanes<W> most{}, spoilt{};
    for (int at = 0; at < count; at += W) {
        Lanes<W> v, size;
        load(value + at, v);
        spoilt += v - v;
        magnitude_of(v, size);
        most_of(size, most);
    }
    double largest = 0, bad = 0;
    for (int j = 0; j < W; ++j) {
        largest = most[j] > largest ? most[j] : largest;
        bad += spoilt[j];
    }
    return largest + bad;
}

constexpr int all_slices = 3;

/// Cuts by adding and subtracting 1.5 * 2^(m + 52 - bits): what is left is the number rounded to a multiple of
/// 2^(m - bits). With |value| < 2^m, bits = 40, 80, 120 and at most 2048 numbers a lane every sum is an integer
/// multiple of its unit with at most 41 + 11 bits: exact. Fewer than all slices are added only if they hold everything:
/// nothing is left below them, and no number is as large as the ceiling, or not finite.
/// @param sum  eight lanes of each slice
/// @return do they hold everything?
template <int W, int slices>
TYPE21_INLINE bool slice_in(const double* value, int count, double ceiling, const double* cut, double* sum) {
    constexpr int parts = 8 / W;
    Lanes<W> total[slices][parts], most{};
    IntegerLanes<Lanes<W>> rest{};
    for (int s = 0; s < slices; ++s)
        for (int p = 0; p < parts; ++p)
            load(sum + 8 * s + W * p, total[s][p]);
    for (int at = 0; at < count; at += 8) {
        for (int p = 0; p < parts; ++p) {
            Lanes<W> left, size;
            load(value + at + W * p, left);
            magnitude_of(left, size);
            most_of(size, most);
            for (int s = 0; s < slices; ++s) {
                const Lanes<W> high = (left + cut[s]) - cut[s];
                total[s][p] += high;
                left -= high;
            }
            rest |= (IntegerLanes<Lanes<W>>)left;  // infinite and no numbers leave no number
        }
    }
    long long remains = 0;
    double largest = 0;
    for (int j = 0; j < W; ++j) {
        remains |= rest[j];
        largest = most[j] > largest ? most[j] : largest;
    }
    const bool everything = (remains & 0x7fffffffffffffff) == 0 && largest < ceiling;
    if (slices < all_slices && !everything) return false;
    for (int s = 0; s < slices; ++s)
        for (int p = 0; p < parts; ++p)
            store(total[s][p], sum + 8 * s + W * p);
    return everything;
}

TYPE21_AVX512 double largest_eight(const double* value, int count) {
    return largest_in<8>(value, count);
}
TYPE21_AVX2 double largest_four(const double* value, int count) {
    return largest_in<4>(value, count);
}
double largest_two(const double* value, int count) {
    return largest_in<2>(value, count);
}
template <int slices>
TYPE21_AVX512 bool slice_eight(const double* value, int count, double ceiling, const double* cut, double* sum) {
    return slice_in<8, slices>(value, count, ceiling, cut, sum);
}
template <int slices>
TYPE21_AVX2 bool slice_four(const double* value, int count, double ceiling, const double* cut, double* sum) {
    return slice_in<4, slices>(value, count, ceiling, cut, sum);
}
template <int slices>
bool slice_two(const double* value, int count, double ceiling, const double* cut, double* sum) {
    return slice_in<2, slices>(value, count, ceiling, cut, sum);
}

double largest_magnitude(const double* value, int count) {
    return compiled_for(this_machine(), largest_eight, largest_four, largest_two)(value, count);
}

template <int slices>
bool slice(const double* value, int count, double ceiling, const double* cut, double* sum) {
    return compiled_for(this_machine(), slice_eight<slices>, slice_four<slices>, slice_two<slices>)(value, count,
                                                                                                    ceiling, cut, sum);
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
    const int position = exponent == 0 ? 0 : exponent - 1;
    const auto at = static_cast<size_t>(position) / 32;
    const int shift = position % 32;
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
    const int whole = n / 8 * 8;
    // Mostly numbers are like those before, and two slices hold them.
    if (whole == n && groups_ + n / 8 <= most_groups && slice<2>(value, n, ceiling_, cut_.data(), lane_.data())) {
        groups_ += n / 8;
        return;
    }
    const double most = largest_magnitude(value, whole);
    const bool ordinary = most == 0 || (most > 0x1p-800 && most < 0x1p900);
    if (ordinary && most > 0) {
        if (!(most < ceiling_)) {
            flush();
            // A little more than needed, so that numbers that grow slowly do not flush again and again.
            const int m = std::ilogb(most) + 4;
            ceiling_ = std::ldexp(1.0, m);
            for (int s = 0; s < 3; ++s)
                cut_[static_cast<size_t>(s)] = std::ldexp(1.5, m + 12 - 40 * s);
        }
        for (int first = 0; first < whole; first += 8 * most_groups) {
            const int count = std::min(whole - first, 8 * most_groups);
            if (groups_ + count / 8 > most_groups) flush_lanes();
            groups_ += count / 8;
            if (slice<all_slices>(value + first, count, ceiling_, cut_.data(), lane_.data())) continue;
            for (int j = first; j < first + count; ++j) {
                double left = value[j];
                for (const double cut : cut_)
                    left -= (left + cut) - cut;
                if (left != 0) add(left);
            }
        }
    }
    for (int j = ordinary ? whole : 0; j < n; ++j)
        add(value[j]);
}

void ExactAccumulator::flush_lanes() {
    for (double& sum : lane_) {
        if (sum != 0) add(sum);
        sum = 0;
    }
    groups_ = 0;
}

void ExactAccumulator::flush() {
    flush_lanes();
    ceiling_ = 0;
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
    carried.flush();
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
    sum.flush();
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
    // The leading bits as an integer, with one more bit that is set if anything lies below.
    const auto digit = [&](int i) {
        return i < 0 ? std::uint64_t{0} : static_cast<std::uint64_t>(sum.digit_[static_cast<size_t>(i)]);
    };
    const int length = 64 - std::countl_zero(digit(top));
    const int last = 32 * top + length - 1;    // position of the leading bit
    const int first = std::max(last - 52, 0);  // position of the last bit that a double holds
    const auto bit = [&](int position) {
        return position >= 0 && ((digit(position / 32) >> (position % 32)) & 1) != 0;
    };
    std::uint64_t mantissa = 0;
    for (int position = last; position >= first; --position)
        mantissa = 2 * mantissa + (bit(position) ? 1 : 0);
    if (bit(first - 1)) {
        bool more = (mantissa & 1) != 0;
        for (int position = first - 2; position >= 0 && !more; --position)
            more = bit(position);
        if (more) ++mantissa;
    }
    const double size = std::ldexp(static_cast<double>(mantissa), first - 1074);
    return negative ? -size : size;
}

}  // namespace type21::optimized
