/// @file Do the main normals look at the blank? A look at time 0, before anything moves.
#pragma once

#include "reference/model/interface_judge.h"

namespace type21 {

/// Warns when most of the main surface that faces the blank looks away from it.
///
/// At most 300 segments spread over the surface are examined (fewer where the blank is very large, so that the work
/// stays below 3e7 distances). For each, d is the way from its centre to the nearest secondary node. Only the segments
/// nearest to the blank are judged: |d| no more than the smallest |d| + largest gap + DEPTH + three segment sizes; and
/// only those whose normal n is not across d: |<n, d>| > 0.02 |d|. The surface looks away when <n, d> < 0 on more than
/// half of the judged area. A blank that starts behind the tool's surface gives the same answer, and needs the same
/// look at the deck. Source: page, head ("normals ... must be oriented toward the secondary surface")
void check_main_normals(const InterfaceJudge& judge);

}  // namespace type21
