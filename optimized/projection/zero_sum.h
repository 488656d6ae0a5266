/// @file An exact test, in doubles, whether a sum of products is zero.
#pragma once

#include <array>

#include "optimized/projection/two_doubles.h"

namespace type21::optimized {

/// A sum of a few products of numbers that are ordinary(). It is stored as an expansion: nonzero doubles that do not
/// overlap. So it is zero when there are none. Source: J. R. Shewchuk, Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates, Discrete and Computational Geometry 18, 1997
/// (grow-expansion).
class ZeroSum {
  public:
    /// Products of three such numbers and their low parts neither overflow nor underflow.
    static bool ordinary(double x) { return x == 0 || (std::abs(x) > 1e-60 && std::abs(x) < 1e60); }

    void add(double x, double y) {
        if (x == 0 || y == 0) return;
        const TwoDoubles product = TwoDoubles::exact_product(x, y);
        add(product.low);
        add(product.high);
    }
    void add(double x, double y, double z) {
        if (x == 0 || y == 0 || z == 0) return;
        const TwoDoubles product = TwoDoubles::exact_product(x, y);
        add(product.low, z);
        add(product.high, z);
    }
    /// Proven to be zero; false as well where it needed more parts than there is space for.
    bool zero() const { return !overflowed_ && count_ == 0; }

  private:
    void add(double x) {
        size_t kept = 0;
        for (size_t i = 0; i < count_; ++i) {
            const TwoDoubles sum = TwoDoubles::exact_sum(x, part_[i]);
            x = sum.high;
            if (sum.low != 0) part_[kept++] = sum.low;
        }
        count_ = kept;
        if (x == 0) return;
        if (count_ < part_.size()) {
            part_[count_++] = x;
        } else {
            overflowed_ = true;
        }
    }

    std::array<double, 24> part_;  ///< in ascending order
    size_t count_ = 0;
    bool overflowed_ = false;
};

}  // namespace type21::optimized
