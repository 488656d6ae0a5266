/// @file Friction of one card: its rules, what /FRICTION replaces, and whether there is friction at all.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Fric and lines 6 to 8 as written. With fric_ID those fields are not used: /FRICTION has its own.
/// Formulation 8, step 1 to step 8; manual page, comments 12, 13, 15.
void check_friction_card(const CardValidator& validator);

/// /FRICTION takes the place of the card's fields; defaults of lines 6 to 8; fields without effect where there is no
/// friction. Formulation 8, step 1.
void apply_friction(const CardValidator& validator);

}  // namespace type21
