/// @file When an interface acts (Formulation 9, step 2).
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference {

/// Tstart <= t <= Tstop, or the sensor alone when there is one.
/// @param time  t_n [time].  Formulation 9, step 2; manual page, comment 20. (D09 drops the sensor when the card is
/// read.)
/// @manual field Tstart, Tstop, sens_ID; comment 20
inline bool active(const ContactModel& model, const Interface& interface, double time) {
    if (interface.sensor >= 0) return model.sensors[static_cast<size_t>(interface.sensor)].on(time);
    return time >= interface.tstart && time <= interface.tstop;
}

}  // namespace type21::reference
