/// @file Filter of the tangential force (page comment 15, equation (13); formulation section 8).
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference {

/// alpha of F_t* = F_old + alpha k v dt1: 1 without a filter.
///   Ifiltr 1: Xfreq      2: 2 pi Xfreq, Xfreq = dt / filtering period      3: 2 pi Xfreq dt1, Xfreq the cutting
///   frequency
/// and never above 1.
/// D06: max(1, 2 pi Xfreq dt1) for Ifiltr 3, which never filters.  D07: 2 pi / Xfreq for Ifiltr 2.
/// D28: with /FRICTION alpha stays that of the card (1 if blank); the flag of /FRICTION only decides whether the step
/// enters.
/// @param step  dt1 of the friction increment [time]
/// @manual eq 13; field Ifiltr, Xfreq; comment 15; departure D06, D07, D28
double filter_constant(const Interface& interface, double step, const AsBuilt& as_built);

}  // namespace type21::reference
