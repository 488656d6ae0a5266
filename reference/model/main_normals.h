/// @file Check that the main normals face the blank, at time 0.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Warns when most of the main surface that is near the blank faces away from it.
///
/// At most 300 segments spread over the surface are examined (fewer where the blank is very large, so that the work
/// stays below 3e7 distances). Each names its nearest secondary node; each node so named names the nearest of the
/// examined segments, and only those pairs count: flanks, and the far side of a closed tool, have nearer segments
/// between them and the blank. With d the way from the segment's centre to the node and n its normal, pairs with |<n,
/// d>| <= 0.02 |d| do not count. The surface faces away when <n, d> < 0 on more than half of their area. A blank
/// that starts behind the tool's surface gives the same warning, and its deck deserves the same check.
/// Formulation 1, step 2; manual page, description.
void check_main_normals(const CardValidator& validator);

}  // namespace type21
