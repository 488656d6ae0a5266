/// @file When an interface acts (page: Tstart, Tstop, comment 20).
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference {

/// Tstart <= t <= Tstop, or the sensor alone when there is one. (D09 drops the sensor when the model is resolved.)
/// @manual field Tstart, Tstop, sens_ID; comment 20
inline bool active(const ContactModel& model, const Interface& interface, double time) {
    if (interface.sensor >= 0) return model.sensors[static_cast<size_t>(interface.sensor)].on(time);
    return time >= interface.tstart && time <= interface.tstop;
}

}  // namespace type21::reference
