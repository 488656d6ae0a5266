/// @file Rules of the card: ranges, fields that exclude each other, fields without effect.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Checks the card as written; changes nothing. Every problem is reported.
void check_interface_card(const CardValidator& validator);

/// Inacti is one of 0, 1, 3, 5, 6, an error otherwise.  Formulation 6, step 1; as built: D20.
void check_inacti(const CardValidator& validator);

}  // namespace type21
