/// @file Friction of one card: what it may say, what /FRICTION replaces, and whether it rubs at all.
#pragma once

#include "reference/model/interface_judge.h"

namespace type21 {

/// Fric and lines 6 to 8 as written. With fric_ID those fields are not used: /FRICTION has its own.
/// Source: page, comments 12, 13, 15; formulation 8
void check_friction_card(const InterfaceJudge& judge);

/// /FRICTION takes the place of the card's fields; defaults of lines 6 to 8; fields that nothing rubs for.
void apply_friction(const InterfaceJudge& judge);

/// fct_IDF scales Fric in law 0 of the card only (page, comment 12).
bool uses_friction_function(const Interface& interface);

/// The friction coefficient of some node can be above 0. Links and defaults are done.
bool rubs(const Model& model, const Interface& interface);

/// The tangential force is filtered: Ifiltr with Xfreq, of the card or of /FRICTION (D28: either).
bool filters_friction(const Model& model, const Interface& interface);

}  // namespace type21
