/// @file kappa in numbers of 100 bits, many nodes at a time, without a single bound.
#pragma once

#include "optimized/projection/project_double.h"

namespace type21::optimized {

/// kappa = high + low [-].
struct FineKappaRows {
    alignas(64) ProjectionBatch::Row high, low;
};

/// The bounds of filter() are proportional to the rounding of one operation, and here that is 2^-47 of what it is in
/// double: where a sub-triangle is foreseen (foreseen_bounds.h), and for the nodes that are meant there, kappa is off
/// by at most this share of what it is off by in double.
constexpr double fine_share = 0x1p-47;

/// The operations of filter() in TwoDoubles. @param count  columns; up to the next multiple of eight are computed
void project_double_double(const ProjectionBatch& rows, int count, FineKappaRows& kappa,
                           SimdWidth machine = this_machine());

}  // namespace type21::optimized
