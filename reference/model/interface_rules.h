/// @file What the card may say: ranges, fields that exclude each other, fields that nobody uses.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Judges the card as written; changes nothing. Every problem is reported. Source: page; formulation 2, 6 to 9.
void check_interface_card(const CardValidator& judge);

}  // namespace type21
