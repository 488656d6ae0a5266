/// @file D38: the abscissa of fct_IDK.
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference::as_built {

/// As documented: the pressure over AscaleK, which is a pressure itself. The heat is then the same in every system of
/// units.
/// As built: AscaleK times the pressure. AscaleK is converted as a pressure all the same, and Kthe is not converted at
/// all (reference/model/card_departures.cpp), so that the heat depends on the work units of the deck.
/// @param pressure  |F_n| / A [pressure]
/// @return abscissa of fct_IDK.  Formulation 12, step 2; Formulation 9, step 7.
/// @manual departure D38
inline double conduction_abscissa(const Interface& interface, double pressure) {
    return interface.ascalek * pressure;
}

}  // namespace type21::reference::as_built
