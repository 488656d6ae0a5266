/// @file D15, D16, D32: heat between blank and tool.
#pragma once

#include "reference/contact/heat_laws.h"

namespace type21::reference::as_built {

/// As documented: radiation while d <= Drad.
/// As built: while d - g <= Drad.
/// @param distance  d = max(delta, 0) [length]
/// @param gap       g [length].  Formulation 12, step 2; Formulation 9, step 6.
/// @manual departure D15
inline HeatZones heat_zones(const Interface& interface, double distance, double gap) {
    HeatZones zones = reference::heat_zones(interface, distance, gap);
    zones.radiation = !zones.conduction && interface.frad > 0 && distance - gap <= interface.drad;
    return zones;
}

/// As documented: the tool gets none of the friction heat.
/// As built, with Ithe_form 1: it gets all of it once more [-].  Formulation 12, step 2; Formulation 9, step 10.
/// @manual departure D16
inline constexpr double friction_heat_to_tool = 1;

/// As documented: K f in series with the sheet over g.
/// As built: f times the whole conductance of K and the sheet.
/// @param exchange      K at pressure 0 [power/(area temperature)]
/// @param share         f [-]
/// @param gap           g [length]
/// @param conductivity  k_s [power/(length temperature)]
/// @return [power/(area temperature)].  Formulation 12, step 2; Formulation 9, step 8.
/// @manual departure D32
inline double distance_conductance(double exchange, double share, double gap, double conductivity) {
    return share * conduction_conductance(exchange, gap, conductivity);
}

}  // namespace type21::reference::as_built
