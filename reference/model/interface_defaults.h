/// @file The defaults of the card.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Every blank or 0 that means something else gets its value; fields that another field makes idle get the value that
/// does nothing. Gapmin, DEPTH and the gaps need the surfaces: see nodal_gaps.h. The as-built values of departures come
/// first (card_reading.h).  Formulation 2, step 6; Formulation 7, step 1; Formulation 9, step 2.
void apply_interface_defaults(const CardValidator& validator);

}  // namespace type21
