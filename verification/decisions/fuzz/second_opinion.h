/// @file An exact answer by other formulas and other code than the reference's: what the fuzzer compares with.
///
/// The reference follows Formulation 3, step 1 to step 6, in space, and it divides. Here the same geometry is worked
/// out in the plane of the sub-triangle, without any division. The two share nothing but the definition.
///
/// With e1 = B - A, e2 = C - A, N = e1 x e2, G = |N|^2, any vector v is (v1 e1 + v2 e2 + v3 N)/G with
///   v1 = <v, e2 x N>,   v2 = <v, N x e1>,   v3 = <v, N>.
/// The lifted corners V' lie in the plane through P parallel to the triangle. Relative to P and times G their
/// coordinates there are, with (i, j) = (0,0), (1,0), (0,1) for A, B, C and h = <P - A, N>, s = <n_V, N>,
///   u_V = G (i, j) - (p1, p2) + (n1, n2) h / s;      U_V = s u_V is free of divisions; h = 0: U_V = u_V, s := 1.
/// A turned-over lifted triangle and the weights of P are areas in the plane:
///   alpha = s_A U_B x U_C,  beta = s_B U_C x U_A,  gamma = s_C U_A x U_B,  S = alpha + beta + gamma > 0,
///   b' = beta / S,  c' = gamma / S.
/// The interpolated normal times S has the slope sigma = alpha s_A + beta s_B + gamma s_C; following it down,
///   b = (p1 sigma - h m1) / (G sigma),  c = (p2 sigma - h m2) / (G sigma),  m = alpha n_A + beta n_B + gamma n_C.
/// e1 and e2 are normal to N, so the side is the sign of h.
#pragma once

#include "verification/decisions/queries/decision_block.h"

namespace type21 {

/// Every segment of the tool is asked, except one whose box is certainly beyond the farthest reach.
/// DecisionAnswer::stage says whether intervals were enough.
/// @throws std::invalid_argument where the limits of the query are not the documented ones
DecisionAnswer second_opinion(const DecisionTool& tool, const ContactQuery& query);

}  // namespace type21
