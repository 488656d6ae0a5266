/// @file Vectors between given points, exactly, and whether they are dependent.
#pragma once

#include <array>

#include "optimized/projection/vector3.h"
#include "optimized/projection/zero_sum.h"

namespace type21::optimized {

/// A vector whose components are exact sums of two doubles, where `known`.
struct ExactVector {
    std::array<double, 3> high{}, low{};
    bool known = true;

    void put(size_t i, const TwoDoubles& v) {
        high[i] = v.high;
        low[i] = v.low;
        known = known && ZeroSum::ordinary(v.high) && ZeroSum::ordinary(v.low);
    }
};

ExactVector exact(const V3& v);
/// q - p.
ExactVector way(const V3& p, const V3& q);
/// The sum of four; unknown where it needs more than two doubles.
ExactVector sum_of(const std::array<V3, 4>& x);
/// 4 p - sum: four times the way from the centre.
ExactVector way_from_sum(const ExactVector& sum, const V3& p);

/// Proven: p x q = 0.
bool parallel(const ExactVector& p, const ExactVector& q);
/// Proven: <p, q x r> = 0.
bool in_one_plane(const ExactVector& p, const ExactVector& q, const ExactVector& r);

}  // namespace type21::optimized
