/// @file The projection in plain double with a proven bound on each number that decides.
#pragma once

#include "optimized/projection/local_segment.h"
#include "reference/contract/decision.h"

namespace type21::optimized {

/// What the filter knows of a node on one sub-triangle.
enum class Verdict {
    rejected,  ///< proven
    taken,     ///< proven, and the kind is proven as well
    too_far,   ///< proven: it projects on the sub-triangle, but is farther than all reaches
    unsure     ///< a number that decides is within its error bound
};

/// Magnitudes of a projection. Source: Formulation 3, steps 1 to 6; Formulation 5, steps 1 to 3.
struct ProjectionResult {
    Kind kind = Kind::none;
    int side = 0;             ///< sign of H; 0: not proven
    double b = 0, c = 0;      ///< weights of Q, unclipped [-]
    double kappa = 0;         ///< [-]
    V3 normal;                ///< n, not of unit length
    double lift = 0;          ///< H / <n, N>: delta = lift |n| [length / |n|]
    double height = 0;        ///< for `too_far` only: a bound of |H| / |N|, with the sign of H [length]
    double least_w = 0;       ///< least weight of step 2, less its bound; 0 where it was not formed [-]
    double weight_bound = 0;  ///< |computed - exact| of b, c and, doubled, of a [-]
    double kappa_bound = 0;   ///< |computed - exact| of kappa [-]
};

struct FilterResult {
    Verdict verdict = Verdict::unsure;
    ProjectionResult projection;  ///< filled when taken or too far
};

/// kappa of a sub-triangle in double-double.
struct KappaDoubleDouble {
    TwoDoubles value;
    double bound = 0;  ///< |computed - exact| [-]
};

/// @param p       the node in the tool frame [length]
/// @param k       sub-triangle, 1..4 (1 for a triangle)
FilterResult filter(const V3& p, const SegmentData& segment, const LocalSegment& local, int k,
                    const ContactReach& reach, const ProjectionLimits& rules);

/// The same in double-double. It settles the near-ties of structured meshes, where kappas differ only by the rounding
/// of coordinates.
FilterResult filter_double_double(const V3& p, const SegmentData& segment, int k, const ContactReach& reach,
                                  const ProjectionLimits& rules, KappaDoubleDouble& kappa);

/// Proven: <n_V, N> is not zero. @param corner  V, 0: A, 1: B, 2: C of sub-triangle k
bool slope_is_not_zero(const SegmentData& segment, const LocalSegment& local, int k, int corner);

}  // namespace type21::optimized
