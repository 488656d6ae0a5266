/// @file The exact answer to a query: the decision, and the normal force rounded once.
#pragma once

#include "reference/exact/fraction.h"
#include "verification/decisions/queries/decision_block.h"

namespace type21::accuracy {

/// k of every node, Istf 1 [N/mm]. The normal law is F = k p with p = max(0, g - delta).
inline constexpr double stiffness = 1000;

struct ExactAnswer {
    DecisionAnswer answer;
    /// There is a force to compare with: the exact answer is contact, its penetration is above rounding, and all
    /// coordinates lie between 1e-60 and 1e60 (a height is a volume and must fit into a double). "Above rounding" is
    /// more than 16 ulp of the numbers that enter, as in the law (Formulation 5, step 4).
    bool forced = false;
    double force = 0;  ///< the exact force, rounded to the nearest double [force]
    double scale = 0;  ///< k times the largest of the gap and the coordinates of node and segment [force]
};

/// The decision is that of the fuzzer's second opinion, which shares no code with any method. The force is computed on
/// its sub-triangle in rational numbers.
ExactAnswer exact_answer_of(const DecisionTool& tool, const ContactQuery& query);

/// The double nearest to k (g - delta), where H, <n, N> and <n, n> of the projection are exact:
///   delta = H |n| / <n, N>.
/// The root is found by Newton's method: a double d, then twice the correction (delta^2 - d^2) / (2 d) with an exact
/// numerator. Its relative error is then below 1e-60.
double exact_force(double k, double gap, const reference::Fraction& height, const reference::Fraction& normal_squared,
                   const reference::Fraction& slope);

}  // namespace type21::accuracy
