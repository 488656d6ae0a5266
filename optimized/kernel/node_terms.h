/// @file What one node adds to the sums.
#pragma once

#include "optimized/kernel/node_data.h"

namespace type21::optimized {

/// Fills the next column of the block.
/// @param step    dt1 [time]   @param center  x_G [length]   @param heat  fill the rows of heat?
void add_terms(const NodeContact& node, double step, const Vec3& center, bool heat, TermBlock& block);

}  // namespace type21::optimized
