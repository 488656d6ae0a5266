/// @file Heat of one card: lines 10 and 11, their distances, and the materials that they ask for.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Checks Ithe and lines 10 and 11 as written.  Formulation 9, step 4 to step 10.
void check_heat_card(const CardValidator& validator);

/// Defaults of line 10. Without Ithe nothing of lines 10 and 11 may reach a search distance or a step limit.
/// Formulation 9, step 7.
void apply_heat(const CardValidator& validator);

/// 1 in the units in which the card is written, in work units.
double one_of_card(const CardValidator& validator, Dimension dimension);

/// The function of Fcond: abscissae and ordinates between 0 and 1, an error otherwise.  Formulation 9, step 8.
void check_distance_function(const CardValidator& validator);

/// Drad and Dcond, in this order; the gaps are known:
///   Frad 0: Drad := 0;  Fcond 0: Dcond := 0;  Fcond with Dcond, Drad 0: Drad := Dcond;  Dcond > Drad: Dcond := Drad
///   Frad or Fcond: Drad 0 -> max(largest g0, shortest secondary edge), else at least the largest g0 (as built: D11)
///   Fcond with Dcond 0: Dcond := Drad (as built: D14)
/// Formulation 9, step 5; manual page, comments 17 and 23.
void resolve_heat_distances(const CardValidator& validator);

/// Dcond := Drad, its default.
void dcond_is_drad(Interface& interface);

/// Every secondary node has a heat capacity; with Ithe_form 1 every main node has one or an imposed temperature; with
/// Ithe 2 alone every main node has a temperature from somewhere; errors otherwise.  Formulation 9, step 4.
/// Formulation 9, step 12.
void check_thermal_sides(const CardValidator& validator);

}  // namespace type21
