/// @file Functions of one variable (/FUNCT) and time sensors (/SENSOR/TIME).
#pragma once

#include <string>
#include <vector>

#include "mesh.h"

namespace type21 {

/// Piecewise linear, extrapolated linearly beyond both ends; one point is a constant.
struct Function {
    Id id = 0;
    std::string title;
    std::vector<double> x;  ///< ascending
    std::vector<double> y;

    /// @return the ordinate; 0 for a function without points.  Formulation 9, step 1.
    double operator()(double abscissa) const;
};

/// On from `delay` on (and off again at `stop`).  Formulation 9, step 2.
struct TimeSensor {
    Id id = 0;
    std::string title;
    double delay = 0;    ///< [time]
    double stop = 1e30;  ///< [time]

    /// @param time  t_n [time]
    bool on(double time) const { return time >= delay && time < stop; }
};

}  // namespace type21
