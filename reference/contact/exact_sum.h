/// @file Sums that no order can change (Formulation 10, step 9).
#pragma once

#include <vector>

#include "reference/contract/vector.h"

namespace type21 {

/// The exact sum of doubles, rounded once at the end: the same bits in any order (Shewchuk 1997, adaptive expansions).
class ExactSum {
  public:
    void add(double value);
    /// The sum, rounded once; 0 for none. A value that is not finite spoils it.
    double value() const;

  private:
    std::vector<double> partials_;  ///< not overlapping, in increasing magnitude
};

/// The same for each component of a vector.
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
