/// @file kappa in numbers of 100 bits, many nodes at a time, without a single bound.
#pragma once

#include "optimized/decide/plain_landing.h"

namespace type21::optimized {

/// kappa = high + low [-].
struct FineKappaRows {
    alignas(64) LandingRows::Row high, low;
};

/// What fine_landing may be off by where the sub-triangle is foreseen (foreseen_bounds.h) and the node meant. The
/// bounds of filter() are proportional to the rounding of one operation, and here that is 2^-47 of what it is in
/// double: 3 q < 1e-6 2^-47, kappa within 4.1 q + 12 e.
constexpr double fine_kappa_share = 2e-20;

/// The operations of filter() in TwoDoubles. @param count  columns; up to the next multiple of eight are computed
void fine_landing(const LandingRows& rows, int count, FineKappaRows& kappa, Machine machine = this_machine());

}  // namespace type21::optimized
