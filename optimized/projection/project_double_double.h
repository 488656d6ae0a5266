/// @file kappa in double-double, many nodes at a time, without error bounds.
#pragma once

#include "optimized/projection/project_double.h"

namespace type21::optimized {

/// kappa = high + low [-].
struct KappaRows {
    alignas(64) ProjectionBatch::Row high, low;
};

/// The bounds of filter() are proportional to the rounding of one operation, which is 2^-47 of that in double. So where
/// the a priori bounds hold, the error of kappa is at most this share of its bound in double.
constexpr double double_double_share = 0x1p-47;

/// The operations of filter() in TwoDoubles. @param count  of columns; those up to the next multiple of eight are
/// computed
void project_double_double(const ProjectionBatch& rows, int count, KappaRows& kappa,
                           SimdWidth machine = this_machine());

}  // namespace type21::optimized
