/// @file The projection in integers: no division, no rounding, always an answer.
#pragma once

#include <gmpxx.h>

#include "optimized/projection/filter.h"

namespace type21::optimized {

/// The answer of one sub-triangle, exact but for the magnitudes in `projection`, which are rounded from exact ones.
struct ExactProjection {
    bool taken = false;  ///< accepted, and near enough for contact or proximity
    ProjectionResult projection;
    /// kappa = kappa_over / (3 kappa_under), kappa_under > 0; both integers.
    mpz_class kappa_over, kappa_under;
};

/// @param k  sub-triangle, 1..4 (1 for a triangle)
/// All of p, segment and reach must be finite.
/// @manual field DEPTH; comment 4; departure D35
ExactProjection project_exact(const V3& p, const SegmentData& segment, int k, const ContactReach& reach,
                              const ProjectionLimits& rules);

/// Sign of kappa of one minus kappa of other.
int compare_kappa(const ExactProjection& one, const ExactProjection& other);

}  // namespace type21::optimized
