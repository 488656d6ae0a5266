/// @file Heat of one card: lines 10 and 11, their distances, and the materials that they ask for.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Ithe and lines 10 and 11 as written. Source: page, comments 16 to 18, 22, 23; formulation 9
void check_heat_card(const CardValidator& judge);

/// Defaults of line 10. Without Ithe nothing of lines 10 and 11 may reach a search distance or a step limit.
/// D36: Kthe 0 with fct_IDK means 1 in the units of the card.
void apply_heat(const CardValidator& judge);

/// The function of Fcond: abscissae and ordinates between 0 and 1. Source: page, comment 22
void check_distance_function(const CardValidator& judge);

/// Drad and Dcond, in this order; the gaps are known:
///   Frad 0: Drad := 0;  Fcond 0: Dcond := 0;  Fcond with Dcond, Drad 0: Drad := Dcond;  Dcond > Drad: Dcond := Drad
///   Frad or Fcond: Drad 0 -> max(largest g0, shortest secondary edge), else at least the largest g0 (D11: always)
///   Fcond with Dcond 0: Dcond := Drad (D14: stays 0)
/// Source: page, comments 17 and 23; formulation 9, 12
void resolve_heat_distances(const CardValidator& judge);

/// Every secondary node has a heat capacity; with Ithe_form 1 every main node has one or an imposed temperature; with
/// Ithe 2 alone every main node has a temperature from somewhere. Source: page, comment 16; formulation 9
void check_thermal_sides(const CardValidator& judge);

}  // namespace type21
