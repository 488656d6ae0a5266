/// @file The projection in plain double with a proven bound on each number that decides.
#pragma once

#include "optimized/projection/local_segment.h"
#include "reference/contract/decision.h"

namespace type21::optimized {

/// What the filter knows of a node on one sub-triangle.
enum class Verdict {
    rejected,  ///< proven
    taken,     ///< proven, and kind is proven, too
    beyond,    ///< proven: it projects on the sub-triangle, and is too far for any of the reaches
    unsure     ///< a number that decides is within its error bound
};

/// Magnitudes of a projection (formulation section 3 and 5).
struct ProjectionResult {
    Kind kind = Kind::none;
    int side = 0;             ///< sign of H; 0: not proven
    double b = 0, c = 0;      ///< weights of Q, unclipped [-]
    double kappa = 0;         ///< [-]
    V3 normal;                ///< n, not of unit length
    double lift = 0;          ///< H / <n, N>: delta = lift |n| [length / |n|]
    double height = 0;        ///< for `beyond` only: a bound of |H| / |N|, with the sign of H [length]
    double innermost = 0;     ///< smallest of the weights of step 2, less its bound; 0 where it was not formed [-]
    double weight_bound = 0;  ///< |computed - exact| of b, c and, doubled, of a [-]
    double kappa_bound = 0;   ///< |computed - exact| of kappa [-]
};

struct FilterResult {
    Verdict verdict = Verdict::unsure;
    ProjectionResult landing;  ///< filled when taken or beyond
};

/// kappa of a sub-triangle in 100 bits.
struct FineKappa {
    TwoDoubles value;
    double bound = 0;  ///< |computed - exact| [-]
};

/// @param p       the node in the tool frame [length]
/// @param k       sub-triangle, 1..4 (1 for a triangle)
FilterResult filter(const V3& p, const SegmentData& segment, const LocalSegment& local, int k,
                    const ContactReach& window, const ProjectionLimits& rules);

/// The same in numbers of 100 bits: near-ties of structured meshes, whose kappa differ in the rounding of coordinates
/// only, end here.
FilterResult fine_filter(const V3& p, const SegmentData& segment, int k, const ContactReach& window,
                         const ProjectionLimits& rules, FineKappa& kappa);

/// Proven: <n_V, N> is not zero. @param corner  V, 0: A, 1: B, 2: C of sub-triangle k
bool slope_is_not_zero(const SegmentData& segment, const LocalSegment& local, int k, int corner);

}  // namespace type21::optimized
