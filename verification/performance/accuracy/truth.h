/// @file What is right: the exact decision and the exact normal force, rounded once.
#pragma once

#include "reference/exact/fraction.h"
#include "verification/decisions/queries/query.h"

namespace type21::accuracy {

/// k of every node, Istf 1: the normal law is F = k p, p = max(0, g - delta) [N/mm].
inline constexpr double stiffness = 1000;

struct Truth {
    DecisionAnswer answer;
    /// There is a force to compare with: the exact answer is contact, its penetration is more than 16 units in the last
    /// place of what enters (of the node's coordinates the law takes as much for rounding), and coordinates lie between
    /// 1e-60 and 1e60 (a height is a volume, and must fit into a double).
    bool forced = false;
    double force = 0;  ///< the exact force rounded to the nearest double [force]
    /// k times the largest of the gap and the coordinates of node and segment: what enters into the force [force]
    double scale = 0;
};

/// The decision is that of the second opinion of the fuzzer, which shares no code with a method; the force follows from
/// its sub-triangle in rational numbers.
Truth truth_of(const DecisionTool& tool, const DecisionQuery& query);

/// The double nearest to k (g - delta), where H, <n, N> and <n, n> of the projection are exact:
///   delta = H |n| / <n, N>.
/// The root is approached from outside: d, then twice the correction (delta^2 - d^2) / (2 d) with an exact numerator,
/// which leaves less than 1e-60 of it.
double exact_force(double k, double gap, const reference::Fraction& height, const reference::Fraction& normal_squared,
                   const reference::Fraction& slope);

}  // namespace type21::accuracy
