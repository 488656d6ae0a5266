/// @file Filter of the tangential force (Formulation 8, step 8).
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference {

/// alpha of F_t* = F_old + alpha k v dt1, never above 1:
///   Ifiltr 0, or Xfreq 0:  1
///   Ifiltr 1:  Xfreq
///   Ifiltr 2:  2 pi Xfreq,      Xfreq = time step / filtering period [-]
///   Ifiltr 3:  2 pi Xfreq dt1,  Xfreq = cutting frequency [1/time]
/// @param interface  Ifiltr (0..3) and Xfreq (>= 0) in force: those of /FRICTION where fric_ID names one
/// @param step       dt1 of the friction increment [time]
/// @return alpha [-].  Formulation 8, step 8; manual page, comment 15, equation (13); as built: D06, D07, D28.
/// @manual eq 13; field Ifiltr, Xfreq; comment 15
double filter_constant(const Interface& interface, double step);

}  // namespace type21::reference
