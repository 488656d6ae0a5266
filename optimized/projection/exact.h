/// @file The projection in whole numbers: no division, no rounding, always an answer.
#pragma once

#include <gmpxx.h>

#include "optimized/projection/filter.h"

namespace type21::optimized {

/// The answer of one sub-triangle, exact but for the magnitudes in `landing`, which are rounded from exact ones.
struct ExactLanding {
    bool taken = false;  ///< accepted, and near enough for contact or proximity
    ProjectionResult landing;
    /// kappa = kappa_over / (3 kappa_under), kappa_under > 0; both whole.
    mpz_class kappa_over, kappa_under;
};

/// @param k  sub-triangle, 1..4 (1 for a triangle)
/// All of p, segment and window must be finite.
/// @manual field DEPTH; comment 4; departure D35
ExactLanding exact_landing(const V3& p, const SegmentData& segment, int k, const ContactReach& window,
                           const ProjectionLimits& rules);

/// Sign of kappa of one minus kappa of other.
int compare_kappa(const ExactLanding& one, const ExactLanding& other);

}  // namespace type21::optimized
