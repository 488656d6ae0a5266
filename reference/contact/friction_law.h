/// @file Friction coefficient (page comments 12, 13; formulation section 8).
#pragma once

#include "reference/model/model.h"

namespace type21::reference {

/// Coulomb, Ifric 0: mu = Fric, of the card or of the /FRICTION that replaces it: of the listed pair of parts, or else
/// its default.
/// @param part_secondary  index into Model::parts of the node's part, -1: none
/// @param part_main       of the main segment's part, -1: none
double coulomb_coefficient(const Model& model, const Interface& interface, int part_secondary, int part_main);

}  // namespace type21::reference
