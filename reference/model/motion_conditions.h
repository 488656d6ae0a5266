/// @file What drives the nodes of a scene: boundary conditions, imposed motion, loads, masses, temperatures.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "reference/contract/mesh.h"

namespace type21 {

/// Axes that do not move: /SKEW/FIX or /FRAME/FIX.
struct Skew {
    Id id = 0;
    std::string title;
    Vec3 origin = Vec3::Zero();    ///< [length]
    Mat3 axes = Mat3::Identity();  ///< columns X', Y', Z': orthonormal, right-handed, in global axes
};

/// Words of the degrees of freedom 0..5: translations, rotations.
inline constexpr std::array<std::string_view, 6> direction_names{"X", "Y", "Z", "XX", "YY", "ZZ"};

/// Degrees of freedom 0..5: translations X Y Z, rotations XX YY ZZ.
struct BoundaryCondition {
    Id id = 0;
    std::array<bool, 6> fixed{};
    int group = -1;  ///< index into Model::groups
    int skew = -1;   ///< index into Model::skews, -1: global axes
};

struct ImposedMotion {
    enum class Kind { velocity, displacement, acceleration };
    Id id = 0;
    Kind kind = Kind::velocity;
    int function = -1;  ///< index into Model::functions
    int direction = 0;  ///< 0..5
    int group = -1;
    int sensor = -1;     ///< index into Model::sensors, -1: none
    double scale_x = 1;  ///< abscissa scale: f(t / scale_x) [time]
    double scale_y = 1;  ///< ordinate scale [velocity, length, acceleration, or per time / radian for rotations]
    double start = 0;    ///< [time]
    double stop = 1e30;  ///< [time]
    int skew = -1;       ///< index into Model::skews, -1: global axes
};

/// /INIVEL, in global axes. TRA gives the nodes a velocity, ROT an angular velocity (only that of a main node counts),
/// AXIS both: velocity + angular_velocity x (x - origin).
struct InitialVelocity {
    enum class Kind { translation, rotation, axis };
    Id id = 0;
    Vec3 velocity = Vec3::Zero();  ///< [velocity]
    int group = -1;
    Kind kind = Kind::translation;
    Vec3 angular_velocity = Vec3::Zero();  ///< [1/time]
    Vec3 origin = Vec3::Zero();            ///< a point of the axis [length]
};

/// A load scale_y * f(t / scale_x) on each node of the group: a force (direction 0..2) or a moment (3..5).
struct ConcentratedLoad {
    Id id = 0;
    int function = -1;
    int direction = 0;
    int group = -1;
    int sensor = -1;
    double scale_x = 1;
    double scale_y = 1;
    int skew = -1;  ///< index into Model::skews, -1: global axes
};

/// /GRAV: an acceleration scale_y * f(t / scale_x) of the nodes of a group; of a rigid body where its main node is in.
struct Gravity {
    Id id = 0;
    int function = -1;   ///< -1: constant
    int direction = 0;   ///< 0..2
    int group = -1;      ///< -1: all nodes
    int sensor = -1;     ///< index into Model::sensors, -1: none
    double scale_x = 1;  ///< [time]
    double scale_y = 1;  ///< [length/time^2]
    int skew = -1;       ///< index into Model::skews, -1: global axes
};

struct AddedMass {
    Id id = 0;
    double mass = 0;      ///< [mass]
    bool shared = false;  ///< type 1: the mass is shared by the group; type 0: each node gets it
    int group = -1;
};

/// /INITEMP: temperature of a group at time 0.
struct InitialTemperature {
    Id id = 0;
    double temperature = 0;
    int group = -1;
};

/// /IMPTEMP: scale_y * f(t / scale_x), t since its sensor switched on, from start to stop.
struct ImposedTemperature {
    Id id = 0;
    int function = -1;
    int group = -1;
    int sensor = -1;
    double scale_x = 1;  ///< [time]
    double scale_y = 1;  ///< [temperature]
    double start = 0;    ///< [time]
    double stop = 1e30;  ///< [time]
};

}  // namespace type21
