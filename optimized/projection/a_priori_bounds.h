/// @file Error bounds of plain projections that hold for every node that a sub-triangle can meet.
#pragma once

namespace type21::optimized {

/// A sub-triangle is a priori bounded when the bounds of filter() are below a_priori_share for every node with
///   |P - o| <= a_priori_size, |H| <= growth |N|, |p|, |q| <= 4, W >= 1/2, weights of step 2 >= -0.01.
/// The share is that of each weight of steps 2 and 3, of H / (|N| size) and of |delta| / size. A bound increases with
/// the numbers that enter it, so the largest numbers give the largest bound (search/weight_lipschitz.cpp). Other nodes
/// go through filter().
constexpr double a_priori_share = 1e-6;  ///< of weights [-], and of heights and distances as a share of the size

/// Weights and kappas of plain projections must be this far from a limit: ten times their error [-].
constexpr double decision_margin = 1e-5;
constexpr double weight_limit = -0.01;  ///< ProjectionLimits::low, but for time 0 with D31, which uses filter()
/// A sub-triangle surely accepts weights of step 3 from here on.
constexpr double sure_weight = weight_limit + decision_margin;

/// Added to an exclusive margin where the sub-triangle is not a priori bounded.
constexpr float not_a_priori_bounded = 4;

/// Upper limit of S of filter() for these nodes. @param extent  of the segment [length]
inline double a_priori_size(double extent, double growth) {
    return extent + 1.5 * growth;
}

}  // namespace type21::optimized
