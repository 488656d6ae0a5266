/// @file The rules of the host that the manual page and the public program read differently.
#pragma once

#include "reference/contract/departures.h"
#include "reference/host/rotation.h"

namespace type21 {

/// Steps that meet in one cycle.
struct CycleSteps {
    double before = 0;       ///< dt1 [time]
    double mean = 0;         ///< (dt1 + dt2)/2; 0 while dt2 is not known [time]
    double mean_before = 0;  ///< the same of the cycle before [time]
};

/// Step of the friction increment: dt1, which led to this cycle.
/// @return [time].  Formulation 11, step 7; as built: D25.
inline double friction_step(const CycleSteps& steps) {
    return steps.before;
}

/// Weight of the impulses of this cycle: the mean of both steps.
/// @return [time].  Formulation 11, step 7; as built: D25.
inline double impulse_weight(const CycleSteps& steps) {
    return steps.mean;
}

/// Orientation of a tool that the contact sees: that of t_n.
/// @param before  that of the cycle before.  Formulation 11, step 1; as built: D24.
inline const Rotation& tool_rotation(const Rotation& now, [[maybe_unused]] const Rotation& before) {
    return now;
}

namespace as_built {

/// As documented: friction increments with dt1, impulses with the mean of both steps. As built: both with the mean of
/// both steps of the cycle before [time].  Formulation 12, step 2.
/// @manual departure D25
inline double step_of_cycle_before(const CycleSteps& steps) {
    return steps.mean_before;
}

/// As documented: orientation and position of a tool are of the same time. As built: the orientation is one step older.
/// Formulation 12, step 2.
/// @manual departure D24
inline const Rotation& tool_rotation([[maybe_unused]] const Rotation& now, const Rotation& before) {
    return before;
}

}  // namespace as_built

/// The reading of the host: as documented where it is default-constructed.
struct HostReading {
    double (*friction_step)(const CycleSteps&) = type21::friction_step;                          // D25
    double (*impulse_weight)(const CycleSteps&) = type21::impulse_weight;                        // D25
    const Rotation& (*tool_rotation)(const Rotation&, const Rotation&) = type21::tool_rotation;  // D24
};

/// The one place where the departures of the host are put in.  Formulation 12, step 1.
inline HostReading host_reading(const AsBuilt& set) {
    HostReading reading;
    if (set.has(Departure::D24)) reading.tool_rotation = as_built::tool_rotation;
    if (set.has(Departure::D25)) reading.friction_step = reading.impulse_weight = as_built::step_of_cycle_before;
    return reading;
}

}  // namespace type21
