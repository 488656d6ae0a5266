/// @file The defaults of the card, and what the departures put in their place.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Every blank or 0 that means something else gets its value; fields that another field makes idle get the value that
/// does nothing. Gapmin, DEPTH and the gaps need the surfaces: see nodal_gaps.h. Source: page; formulation 2, 6 to 9;
/// 12 for D02 to D20.
void apply_interface_defaults(const CardValidator& judge);

}  // namespace type21
