/// @file /SENSOR: what switches interfaces, drives and loads on and off.
#pragma once

#include <string>
#include <vector>

#include "reference/contract/mesh.h"

namespace type21 {

/// Formulation 9, step 2.
struct Sensor {
    enum class Kind {
        time,      ///< TIME: on for delay <= t < stop
        all,       ///< AND, SENS: all of `of` are on
        any,       ///< OR: one of `of` is on
        none,      ///< NOT: `of` is off
        distance,  ///< DIST: the distance of two nodes is outside of low..high
        force,     ///< INTER: the contact force of an interface is outside of low..high
        unsupported
    };
    /// Of the force on the tool: the size of its normal or tangential part, or a component of the whole.
    enum class Force { normal, tangential, x, y, z };

    Id id = 0;
    std::string title;
    Kind kind = Kind::time;
    double delay = 0;       ///< Tdelay: how long what it looks at must have held before it is on [time]
    double stop = 1e30;     ///< TIME only [time]
    std::vector<int> of{};  ///< index into Model::sensors

    int node_a = -1;     ///< index into Model::nodes
    int node_b = -1;     ///< likewise
    int interface = -1;  ///< index into Model::interfaces
    Force part = Force::normal;
    double low = -1e30;  ///< Dmin, Fmin [length] or [force]
    double high = 1e30;  ///< Dmax, Fmax [length] or [force]
    double lasting = 0;  ///< Tmin: how long distance or force must stay outside [time]
};

}  // namespace type21
