/// @file Are the doubles of a projection good enough to compute forces with? (Formulation 10, step 7)
#pragma once

#include "reference/exact/bounded.h"
#include "reference/exact/staged_impact.h"

namespace type21::reference {

/// How large the error bounds of a retained projection may be. The bounds are some ten to a thousand times the errors;
/// those of common meshes lie far below these limits. Where a bound is larger, the exact number is rounded instead.
/// This happens near a point where the normals meet and the lifted triangle shrinks to nothing.
struct MagnitudeLimits {
    static constexpr double weights = 0x1p-30;   ///< for b and c [-]; for n, as a share of |n| [-]
    static constexpr double distance = 0x1p-40;  ///< for delta, as a share of the largest length that enters [-]
};

/// True where the error bounds of a retained projection keep MagnitudeLimits.
/// @param largest  largest coordinate of node and segment, in magnitude: largest_length() [length]
bool close_enough(const Projection<Bounded>& projection, double largest);

/// The same for a sub-triangle that intervals or rational numbers found to take the node: the projection is computed in
/// Bounded once more, without limits on the weights. What Bounded could not decide may have been a limit or the reach,
/// and the numbers of a projection do not depend on those.
bool close_enough(const ContactQuery& query, const SegmentShape<double>& shape, int k);

/// Largest coordinate of node and segment, in magnitude [length].
double largest_length(const Vec3& point, const SegmentShape<double>& shape);

}  // namespace type21::reference
