/// @file Copies the data of sub-triangles into the rows of a projection.
#pragma once

#include "optimized/projection/project_double.h"
#include "optimized/projection/sub_triangle_id.h"
#include "optimized/search/tool.h"

namespace type21::optimized {

/// Fills corner, normal, code and size of `count` columns from `first` on, a multiple of four, and may fill those up to
/// the next multiple. @param growth  of a_priori_size [length]
void gather(ProjectionBatch& rows, const Tool& tool, const SubTriangleId* id, int first, int count, double growth,
            SimdWidth machine = this_machine());
/// The same after Tool::prefetch_corners has been called for their segments.
void gather_prefetched(ProjectionBatch& rows, const Tool& tool, const SubTriangleId* id, int first, int count,
                       double growth, SimdWidth machine = this_machine());

}  // namespace type21::optimized
