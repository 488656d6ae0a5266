/// @file A sum of doubles without rounding until it is read: no order, no grouping, no thread changes a bit of it.
#pragma once

#include <array>
#include <cstdint>

namespace type21::optimized {

/// Holds sum = sum_i digit_i 2^(32 i - 1074) with signed 64-bit digits: the bits of any double fall into three
/// neighbouring digits of 32, so 2^31 additions fit before carries must be passed on (they are, earlier).
/// Source of the idea: R. Neal, Fast exact summation using small and large superaccumulators, 2015.
class ExactAccumulator {
  public:
    void add(double value);
    /// Adds n numbers, and is quicker than one after the other: each is cut, exactly, into slices of 40 bits below a
    /// power of two that none exceeds; up to 2048 slices sum without rounding in a double.
    void add_block(const double* value, int n);
    void add(const ExactAccumulator& other);
    /// The sum, rounded once to nearest even.
    double value() const;
    void clear() { *this = {}; }

  private:
    static constexpr int digits = 68;  // (2046 + 53) / 32 + 2, and one for carries
    static constexpr std::int32_t most_additions = 1 << 29;

    static constexpr int most_groups = 2048;

    void carry();
    /// The slices go to the digits. flush: the next block chooses its own power of two.
    void flush_lanes();
    void flush();

    std::array<std::int64_t, digits> digit_{};
    std::int32_t additions_ = 0;
    double not_finite_ = 0;  ///< sum of the infinities and NaNs met
    std::array<double, 3> cut_{};
    std::array<double, 24> lane_{};  ///< eight of each slice
    double ceiling_ = 0;             ///< 2^m
    int groups_ = 0;                 ///< numbers in each lane
};

}  // namespace type21::optimized
