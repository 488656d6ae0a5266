/// @file What drives nodes and tools: functions, boundary conditions, imposed motion, loads, rigid bodies.
#pragma once

#include <string>
#include <vector>

#include "reference/model/mesh.h"

namespace type21 {

/// Piecewise linear, extrapolated linearly beyond both ends; one point is a constant.
struct Function {
    Id id = 0;
    std::string title;
    std::vector<double> x;  ///< ascending
    std::vector<double> y;

    double operator()(double abscissa) const;
};

/// Degrees of freedom 0..5: translations X Y Z, rotations XX YY ZZ.
struct BoundaryCondition {
    Id id = 0;
    std::array<bool, 6> fixed{};
    int group = -1;  ///< index into Model::groups
};

struct ImposedMotion {
    enum class Kind { velocity, displacement };
    Id id = 0;
    Kind kind = Kind::velocity;
    int function = -1;  ///< index into Model::functions
    int direction = 0;  ///< 0..5
    int group = -1;
    int sensor = -1;     ///< index into Model::sensors, -1: none
    double scale_x = 1;  ///< abscissa scale: f(t / scale_x) [time]
    double scale_y = 1;  ///< ordinate scale [velocity, length, or per time / radian for rotations]
    double start = 0;    ///< [time]
    double stop = 1e30;  ///< [time]
};

struct InitialVelocity {
    Id id = 0;
    Vec3 velocity = Vec3::Zero();
    int group = -1;
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

/// On from `delay` on (and off again at `stop`).
struct TimeSensor {
    Id id = 0;
    std::string title;
    double delay = 0;    ///< [time]
    double stop = 1e30;  ///< [time]

    bool on(double time) const { return time >= delay && time < stop; }
};

/// /RBODY: its nodes move as one about the main node.
struct RigidBody {
    Id id = 0;
    std::string title;
    int main_node = -1;
    std::vector<int> nodes;       ///< secondary nodes of the body, ascending, without the main node
    double mass = 0;              ///< of the whole body, by its ICoG rule [mass]
    Mat3 inertia = Mat3::Zero();  ///< about the centre, global axes at time 0 [mass length^2]
    Vec3 center = Vec3::Zero();   ///< position of the main node after ICoG has moved it [length]
    int icog = 1;
    bool spherical = false;  ///< Ispher
};

/// One part pair of /FRICTION, or its default.
struct FrictionCoefficients {
    double fric = 0;
    std::array<double, 6> c{};
};

struct FrictionPair {
    int part_a = -1;
    int part_b = -1;
    FrictionCoefficients coefficients;
};

/// /FRICTION: replaces the friction fields of the interfaces that name it.
struct FrictionModel {
    Id id = 0;
    std::string title;
    int ifric = 0;
    int ifiltr = 0;
    double xfreq = 0;
    FrictionCoefficients fallback;
    std::vector<FrictionPair> pairs;
    int line = 0;
};

}  // namespace type21
