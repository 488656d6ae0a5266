/// @file Whether the doubles of a projection are good enough to compute forces with, by the bounds of their errors.
#pragma once

#include "reference/exact/bounded.h"
#include "reference/exact/staged_impact.h"

namespace type21::reference {

/// How far the doubles of a retained projection may be from the exact ones by their bounds, which are some ten to a
/// thousand times the errors. Where they say more, as near a point where the normals meet and the lifted triangle
/// shrinks to nothing, the exact ones are rounded in their place. The bounds of common meshes lie far below.
struct MagnitudeLimits {
    static constexpr double weights = 0x1p-30;   ///< of b and c [-]; of n in parts of |n|
    static constexpr double distance = 0x1p-40;  ///< of delta, in parts of the largest length that enters
};

/// True where the bounds of a retained projection keep MagnitudeLimits.
/// @param largest  of the coordinates of node and segment, in magnitude [length]
bool close_enough(const Projection<Bounded>& projection, double largest);

/// The same from the beginning: for a sub-triangle that another arithmetic than Bounded found to take the node. What
/// could not be decided may have been its reach or its border, which magnitudes do not depend on.
bool close_enough(const DecisionInput& input, const SegmentShape<double>& shape, int k);

/// Of the coordinates of node and segment, in magnitude [length].
double largest_length(const Vec3& point, const SegmentShape<double>& shape);

}  // namespace type21::reference
