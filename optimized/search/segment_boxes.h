/// @file Boxes of all segments of a tool, several at a time.
#pragma once

#include <vector>

#include "optimized/search/capture_volume.h"
#include "optimized/search/tool.h"

namespace type21::optimized {

/// A box for each segment that holds the prisms of its sub-triangles (Prism::box, but for rounding far below its
/// slack).
std::vector<Box> segment_boxes(const Tool& tool, const Limits& limits, SimdWidth machine = this_machine());

}  // namespace type21::optimized
