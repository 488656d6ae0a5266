/// @file What one node adds to the sums.
#pragma once

#include "optimized/kernel/node_data.h"

namespace type21::optimized {

/// Fills the next column of the block.
/// @param heat  of the node; null: the rows of heat are not filled
/// @param step  dt1 [time]   @param center  x_G [length]
void add_terms(const NodeContact& node, const NodeHeat* heat, double step, const Vec3& center, TermBlock& block);

}  // namespace type21::optimized
