/// @file How far off a plain projection may be, and how fast its weights change as the node moves.
#pragma once

#include <vector>

#include "optimized/search/tool.h"

namespace type21::optimized {

/// How far weights may go below 0 where a rate still holds.
constexpr double rate_weights = 0.21;

/// A proven bound on |dw| / |dy| of each weight w of step 2 and of step 3 of formulation section 3, wherever the
/// weights of step 2 are >= -rate_weights and the height is at most max(outward, inward) + 0.05 width [1/length];
/// infinite where none is proven. kappa changes by at most twice as much: kappa = sum of |1/3 - w_i|, sum of w_i = 1,
/// so that of the three signs two are equal and d kappa = +- 2 dw_j for the third.
///
/// With the unit normal N^, nu_i = <n_i, N^> > 0, r_i = n_i / nu_i - N^ in the plane, and h = H / |N|: the lifted
/// corners are V_i + h r_i. Let rho = max |r_i|, d = max |r_i - r_j|, omega_0 the width (least height) of the triangle.
///   Width of the lifted triangle: in each direction its extent changes by at most |h| d, so omega >= omega_0 - |h| d.
///   Step 2, P = sum w_i (V_i + h r_i): sum dw_i (V_i + h r_i) = dp - dh sum w_i r_i, and sum dw_i = 0, so that |dw_i|
///   <= |dp - dh sum w_i r_i| / omega. With weights >= -0.06, sum |w_i| <= 1.24:
///     |dw_i| <= sqrt(1 + (1.24 rho)^2) / omega |dy| = g |dy|.
///   Step 3, Q = P - h (N^ + s), s = sum w_i nu_i r_i / S, S = sum w_i nu_i >= 1.12 nu_min - 0.12 nu_max, and ds = sum
///   dw_i nu_i (r_i - s) / S. With m = 1.24 nu_max / S, which bounds sum |w_i nu_i| / S: |s| <= m rho, |r_i - s| <= m d,
///   and sum |dw_i| <= 2 g |dy|:
///     |dQ| <= (sqrt(1 + (m rho)^2) + |h| 2 g m^2 d) |dy|, and a weight of Q changes by at most |dQ| / omega_0.
/// All of it is well conditioned where the prism is not `grown`; 1e-5 is added for its rounding.
///
/// It is infinite where the bounds that filter() derives are not small for every node meant (foreseen_bounds.h), and
/// no_rate where only the rate is missing.
/// @param growth  max(outward, inward) [length]
/// @return four for a segment, rounded up
std::vector<float> weight_rates(const Tool& tool, double growth, Machine machine = this_machine());

constexpr double no_rate = 1e30;

}  // namespace type21::optimized
