/// @file When an interface acts (Formulation 9, step 2).
#pragma once

#include "reference/contract/interface.h"
#include "reference/contract/motion.h"

namespace type21::reference {

/// Tstart <= t <= Tstop, or the sensor alone when there is one.
/// @param motion  of cycle n: its time and the sensors that are on.  Formulation 9, step 2; manual page, comment 20.
/// (D09 drops the sensor when the card is read.)
/// @manual field Tstart, Tstop, sens_ID; comment 20
inline bool active(const Interface& interface, const Motion& motion) {
    if (interface.sensor >= 0) return motion.sensor_on[static_cast<size_t>(interface.sensor)];
    return motion.time >= interface.tstart && motion.time <= interface.tstop;
}

}  // namespace type21::reference
