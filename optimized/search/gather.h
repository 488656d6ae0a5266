/// @file Sub-triangles into the rows of a projection.
#pragma once

#include "optimized/projection/project_double.h"
#include "optimized/search/tool.h"

namespace type21::optimized {

/// Sub-triangle k of a segment as one number, and back.
inline int place_of(int segment, int piece) {
    return 4 * segment + piece - 1;
}
inline int segment_of(int place) {
    return place >> 2;
}
inline int piece_of(int place) {
    return (place & 3) + 1;
}

/// Fills corner, normal, code and size of `count` columns from `first` on, a multiple of four, and may fill those up to
/// the next one. @param growth  of foreseen_size [length]
void gather(ProjectionBatch& rows, const Tool& tool, const int* place, int first, int count, double growth,
            SimdWidth machine = this_machine());
/// The same where Tool::prefetch_corners has been called for them.
void gather_asked(ProjectionBatch& rows, const Tool& tool, const int* place, int first, int count, double growth,
                  SimdWidth machine = this_machine());

}  // namespace type21::optimized
