/// @file Which sensors are on in a cycle (Formulation 9, step 2).
#pragma once

#include <vector>

#include "reference/contract/contact_step.h"
#include "reference/model/model.h"

namespace type21 {

/// One sensor. Plain data: part of the state of a run.
struct SensorState {
    bool on = false;
    double since = 0;        ///< when it became on or off; for a function of a drive, its time counts from here [time]
    bool holds = false;      ///< what it looks at is so, whether or not Tdelay has passed
    double holds_since = 0;  ///< [time]
    bool decided = false;    ///< DIST, INTER: it held for Tmin, so it goes on after Tdelay whatever happens

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(on, since, holds, holds_since, decided);
    }
};

/// Force of one interface on its tool in the cycle before; what /SENSOR/INTER looks at.
struct InterfaceForce {
    Vec3 normal = Vec3::Zero();      ///< [force]
    Vec3 tangential = Vec3::Zero();  ///< [force]

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(normal, tangential);
    }
};

/// Brings the sensors that something uses to t_n.
/// @param time      t_n [time]
/// @param position  x_n of each node [length]
/// @param forces    of the cycle before, one for each interface
/// @param sensors   of the cycle before, one for each of Model::sensors; changed
void update_sensors(const Model& model, double time, const std::vector<Vec3>& position,
                    const std::vector<InterfaceForce>& forces, std::vector<SensorState>& sensors);

/// What the sensors of the next cycle see of the contacts of this one.
void note_forces(const std::vector<ContactStep>& steps, std::vector<InterfaceForce>& forces);

}  // namespace type21
