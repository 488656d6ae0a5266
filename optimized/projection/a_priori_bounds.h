/// @file What a plain projection may be off by where the error bounds of filter() are small for every node that a
/// sub-triangle may meet.
#pragma once

namespace type21::optimized {

/// A sub-triangle is foreseen when, for every node with |P - o| <= foreseen_size, |H| <= growth |N|, |p|, |q| <= 4, W
/// >= 1/2 and weights of step 2 >= -0.01, bounds like those that filter() derives are below foreseen_share: of each
/// weight of step 2 and 3 and of H / (|N| size), |delta| / size. They grow with the numbers that they are made of, so
/// the largest of these give the largest bounds (search/rates.cpp). Nodes for which more is needed are filtered.
constexpr double foreseen_share = 1e-6;  ///< of weights [-], and of heights and distances as a share of the size

/// What weights and kappa of plain projections must be away from what decides: ten times what they may be off by.
constexpr double plain_share = 1e-5;
constexpr double weight_limit = -0.01;  ///< Rules::low of all but the first look of D31, which asks filter()
/// Weights of step 3 that a sub-triangle surely takes.
constexpr double plain_weight = weight_limit + plain_share;

/// Added to a core where the sub-triangle is not foreseen.
constexpr float beyond_foreseen = 4;

/// Size that S of filter() does not exceed for the nodes meant here. @param extent  of the segment [length]
inline double foreseen_size(double extent, double growth) {
    return extent + 1.5 * growth;
}

}  // namespace type21::optimized
