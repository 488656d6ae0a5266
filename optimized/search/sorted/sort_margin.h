/// @file The margin of the sorted search, from the field Bumult.
#pragma once

#include "reference/contract/scene.h"

namespace type21::optimized {

/// How far a node may move in the tool frame before its candidates are looked for again [length]:
///   Bumult max(mean side, 1.251 DEPTH, 1.251 proximity),
/// with the mean side of the segments of the secondary surface at time 0, or of the tool where that surface has none.
/// Source: Formulation 4, step 1.
/// @param proximity  how far heat reaches beyond the gap [length]
/// @param bumult     instead of that of the card; 0: that of the card [-]
double sort_margin(const ContactModel& model, const Interface& card, double proximity, double bumult = 0);

}  // namespace type21::optimized
