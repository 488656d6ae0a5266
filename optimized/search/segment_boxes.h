/// @file Boxes of all segments of a tool, several at a time.
#pragma once

#include <vector>

#include "optimized/search/capture_volume.h"
#include "optimized/search/tool.h"

namespace type21::optimized {

/// A box for each segment that holds the capture volumes of its sub-triangles (CaptureVolume::box, but for rounding far
/// below its slack).
std::vector<Box> segment_boxes(const Tool& tool, const CaptureLimits& limits, SimdWidth machine = this_machine());

}  // namespace type21::optimized
