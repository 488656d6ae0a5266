/// @file Friction of one card: what it may say, what /FRICTION replaces, and whether it rubs at all.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Fric and lines 6 to 8 as written. With fric_ID those fields are not used: /FRICTION has its own.
/// Source: page, comments 12, 13, 15; formulation 8
void check_friction_card(const CardValidator& judge);

/// /FRICTION takes the place of the card's fields; defaults of lines 6 to 8; fields that nothing rubs for.
void apply_friction(const CardValidator& judge);

}  // namespace type21
