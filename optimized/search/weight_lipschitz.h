/// @file Lipschitz bounds of the weights: how fast they change as the node moves. A priori bounds of plain projections.
#pragma once

#include <cstdint>
#include <vector>

#include "optimized/search/tool.h"

namespace type21::optimized {

/// How far below 0 the weights of step 2 may be where a Lipschitz bound still holds.
constexpr double lipschitz_weights = 0.21;
/// Accepted weights are >= -0.01. They stay >= -lipschitz_weights within a distance of this over the Lipschitz bound.
constexpr double lipschitz_reach = 0.2;

/// A proven bound on |dw| / |dy| of each weight w of Formulation 3, step 2 and of Formulation 3, step 3, wherever
/// the weights of step 2 are >= -lipschitz_weights = -q and the height is at most max(outward, inward) +
/// lipschitz_reach width [1/length]; no_lipschitz where none is proven. kappa changes by at most twice as much: kappa =
/// sum of |1/3 - w_i|, sum of w_i = 1, so that of the three signs two are equal and d kappa = +- 2 dw_j for the third.
///
/// With the unit normal N^, nu_i = <n_i, N^> > 0, r_i = n_i / nu_i - N^ in the plane, and h = H / |N|: the lifted
/// corners are V_i + h r_i. Let rho = max |r_i|, d = max |r_i - r_j|, omega_0 the width (least height) of the triangle.
///   Width of the lifted triangle: in each direction its extent changes by at most |h| d, so omega >= omega_0 - |h| d.
///   Step 2, P = sum w_i (V_i + h r_i): sum dw_i (V_i + h r_i) = dp - dh sum w_i r_i, and sum dw_i = 0, so that |dw_i|
///   <= |dp - dh sum w_i r_i| / omega. Two of the weights may be negative, so sum |w_i| <= 1 + 4 q:
///     |dw_i| <= sqrt(1 + ((1 + 4 q) rho)^2) / omega |dy| = g |dy|.
///   Step 3, Q = P - h (N^ + s), s = sum w_i nu_i r_i / S, S = sum w_i nu_i >= (1 + 2 q) nu_min - 2 q nu_max, and
///   ds = sum dw_i nu_i (r_i - s) / S. With m = (1 + 4 q) nu_max / S, which bounds sum |w_i nu_i| / S: |s| <= m rho,
///   |r_i - s| <= m d, and sum |dw_i| <= 2 g |dy|:
///     |dQ| <= (sqrt(1 + (m rho)^2) + |h| 2 g m^2 d) |dy|, and a weight of Q changes by at most |dQ| / omega_0.
/// A bound is at least 1 / omega_0, so a way of lipschitz_reach over it adds at most lipschitz_reach width to a height.
/// All of it is well conditioned where the plane is trusted and no normal leans far, as in capture_volume(); 1e-5 is
/// added for its rounding.
///
/// Infinite where the sub-triangle is not a priori bounded (a_priori_bounds.h).
struct LipschitzBounds {
    std::vector<float> lipschitz;  ///< L, four a segment, rounded up [1/length]
    /// One a segment: the error of kappa of a plain projection is at most 2^-kappa_bits, on its a priori bounded
    /// sub-triangles and for the nodes that a_priori_bounds.h names.
    std::vector<std::uint8_t> kappa_bits;
    friend bool operator==(const LipschitzBounds&, const LipschitzBounds&) = default;
};
/// @param growth  max(outward, inward) [length]
LipschitzBounds lipschitz_bounds(const Tool& tool, double growth, SimdWidth machine = this_machine());

constexpr double no_lipschitz = 1e30;

}  // namespace type21::optimized
