/// @file Sums that no order can change.
#pragma once

#include <vector>

#include "reference/contract/vector.h"

namespace type21 {

/// The exact sum of doubles, rounded once at the end: the same bits in any order (Shewchuk 1997, adaptive expansions).
class ExactSum {
  public:
    void add(double value);
    double value() const;

  private:
    std::vector<double> partials_;  ///< not overlapping, in increasing magnitude
};

class ExactVectorSum {
  public:
    void add(const Vec3& v) {
        for (int i = 0; i < 3; ++i)
            sums_[i].add(v[i]);
    }
    Vec3 value() const { return {sums_[0].value(), sums_[1].value(), sums_[2].value()}; }

  private:
    ExactSum sums_[3];
};

}  // namespace type21
