/// @file The Motion: everything that the contact may know of one cycle.
#pragma once

#include <span>
#include <vector>

#include "vector.h"

namespace type21 {

/// Pose of a tool at t_n and its velocities at n - 1/2, global axes.  Formulation 1, step 1.
struct ToolMotion {
    Vec3 position = Vec3::Zero();          ///< x_G [length]
    Mat3 rotation = Mat3::Identity();      ///< R, from the axes of time 0 to those of t_n (one step older with D24)
    Vec3 velocity = Vec3::Zero();          ///< V_t [velocity]
    Vec3 angular_velocity = Vec3::Zero();  ///< Omega [1/time]
};

/// State at cycle n.  Formulation 11, step 1. The spans are indexed like ContactModel::nodes and must outlive the step.
struct Motion {
    double time = 0;                 ///< t_n, the accumulated sum of steps [time]
    double step = 0;                 ///< dt1 = t_n - t_{n-1}, 0 in the first cycle [time]
    double friction_step = 0;        ///< step of the friction increment: dt1, or another with D25 [time]
    std::span<const Vec3> position;  ///< x_n [length]
    std::span<const Vec3> velocity;  ///< v_{n-1/2} [velocity]
    /// Thickness of each of ContactModel::shells at the end of the cycle before [length]; empty while no thickness
    /// changes.
    std::span<const double> thickness;
    /// Temperature of each node at the end of the cycle before [temperature]; empty in a scene without heat.
    std::span<const double> temperature;
    std::vector<ToolMotion> tools;  ///< one for each rigid body of the model
    /// Which sensors are on at t_n, by the index that Interface::sensor holds; may be empty where no interface has one.
    std::vector<bool> sensor_on;
};

}  // namespace type21
