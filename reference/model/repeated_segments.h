/// @file Segments that a surface holds more than once.
#pragma once

#include <array>
#include <vector>

#include "reference/model/card_validator.h"

namespace type21 {

/// Equal for segments with the same nodes, in whatever order; a triangle has -1 in place of the repeated one.
std::array<int, 4> sorted_nodes(const Segment& segment);

/// Ranks, ascending, of the segments with the nodes of an earlier one, in whatever order. Linear in their number.
std::vector<int> repeated_segments(const Surface& surface);

/// Notes them in the two surfaces of an interface, with one warning for each surface that has some. They count once in
/// areas, in the mean thickness of Gapmin's default and in normals (as built, D41: each time they are listed).
/// @param model  the one of the validator.  Formulation 1, step 4; Formulation 7, step 3.
void note_repeated_segments(const CardValidator& validator, Model& model);

}  // namespace type21
