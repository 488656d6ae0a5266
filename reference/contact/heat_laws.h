/// @file Laws of the heat between blank and tool (Formulation 9, step 5 to step 9).
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference {

/// How far heat reaches beyond the gap: the larger of Drad, if Frad is given, and Dcond, if Fcond is given.
/// @return reach of a proximity [length], 0 without heat.  Formulation 9, step 5; as built: D11.
double heat_reach(const Interface& interface);

/// Which of the zones a node is in, by its distance d = max(delta, 0).
struct HeatZones {
    bool conduction = false;  ///< d <= g
    bool distance = false;    ///< g < d <= Dcond, Fcond given
    bool radiation = false;   ///< g < d <= Drad, Frad given

    bool any() const { return conduction || distance || radiation; }
};

/// @param distance  d = max(delta, 0) [length]
/// @param gap       g [length]
/// @return the zones; the last two may hold together.  Formulation 9, step 6; manual page, comments 17 and 23; as
/// built: D15.
/// @manual eq 16; field Drad, Dcond; comment 17, 23
HeatZones heat_zones(const Interface& interface, double distance, double gap);

/// Abscissa of fct_IDK: the pressure over AscaleK, in equation (15).
/// @param pressure  |F_n| / A [pressure]
/// @return [-].  Formulation 9, step 7; as built: D38.
/// @manual field AscaleK
double conduction_abscissa(const Interface& interface, double pressure);

/// Conductance of the gap, per area:  1 / (d/k_s + 1/K), equation (14); 0 where K or the conductivity is 0.
/// @param exchange      K, Kthe or Kthe f_K(|F_n| / (A AscaleK)), equation (15) [power/(area temperature)]
/// @param distance      d [length]
/// @param conductivity  k_s of the blank [power/(length temperature)]
/// @return [power/(area temperature)], >= 0.  Formulation 9, step 7; manual page, comment 16.
/// @manual eq 14; field Kthe; comment 16
double conduction_conductance(double exchange, double distance, double conductivity);

/// Beyond the gap: K f in series with the sheet over g, f = f_cond((d - g)/(Dcond - g)), equation (20).
/// @param exchange      K at pressure 0 [power/(area temperature)]
/// @param share         f, 0 to 1 [-]
/// @param gap           g [length]
/// @param conductivity  k_s [power/(length temperature)]
/// @return [power/(area temperature)], >= 0.  Formulation 9, step 8; manual page, comment 22; as built: D32.
/// @manual eq 20; field Fcond, Dcond; comment 22
double distance_conductance(double exchange, double share, double gap, double conductivity);

/// Radiated power per area: Frad (T_m^4 - T_s^4), equation (17).
/// @param frad               Frad [power/(area temperature^4)]
/// @param tool_temperature   T_m, absolute [temperature]
/// @param blank_temperature  T_s, absolute [temperature]
/// @return h_r (T_m - T_s), to the blank [power/area].  Formulation 9, step 9; manual page, comment 17.
/// @manual eq 17; field Frad; comment 17
double radiated(double frad, double tool_temperature, double blank_temperature);

/// h_r = Frad (T_m^2 + T_s^2)(T_m + T_s), what radiation conducts per area: for the thermal step.
/// @return [power/(area temperature)].  Formulation 9, step 9; Formulation 11, step 3.
double radiant_conductance(double frad, double tool_temperature, double blank_temperature);

}  // namespace type21::reference
