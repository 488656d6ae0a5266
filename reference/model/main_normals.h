/// @file Do the main normals look at the blank? A look at time 0, before anything moves.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Warns when most of the main surface that faces the blank looks away from it.
///
/// At most 300 segments spread over the surface are examined (fewer where the blank is very large, so that the work
/// stays below 3e7 distances). Each names its nearest secondary node; each node so named names the nearest of the
/// examined segments, and only those pairs are judged: flanks, and the far side of a closed tool, have nearer segments
/// between them and the blank. With d the way from the segment's centre to the node and n its normal, pairs with |<n,
/// d>| <= 0.02 |d| say nothing. The surface looks away when <n, d> < 0 on more than half of the judged area. A blank
/// that starts behind the tool's surface gives the same answer, and needs the same look at the deck. Source: page, head
/// ("normals ... must be oriented toward the secondary surface")
void check_main_normals(const CardValidator& judge);

}  // namespace type21
