/// @file The state of the march: nodes and tools at t_n, velocities at n - 1/2 (Formulation 11, step 1).
#pragma once

#include <vector>

#include "reference/contract/motion.h"
#include "reference/host/conditions.h"
#include "reference/host/host_reading.h"
#include "reference/host/rotation.h"
#include "reference/host/sensors.h"
#include "reference/model/host_scene.h"

namespace type21 {

/// One rigid body.
struct BodyState {
    Vec3 position = Vec3::Zero();                     ///< x_G [length]
    Rotation rotation = Rotation::Identity();         ///< from the axes of time 0 to those of t_n [-]
    Rotation rotation_before = Rotation::Identity();  ///< of the cycle before [-]
    Vec3 velocity = Vec3::Zero();                     ///< [velocity]
    Vec3 angular_velocity = Vec3::Zero();             ///< [1/time]
    Vec3 imposed_angle = Vec3::Zero();  ///< integral of each rotation component since the start, for /IMPDISP [rad]
};

/// All nodes and bodies. Vectors of nodes are indexed like Model::nodes, bodies like Model::rigid_bodies.
struct HostState {
    /// The state of time 0: positions of the deck, initial velocities and temperatures.
    explicit HostState(const Model& model);

    /// Brings the nodes of the bodies to where their body is, with its velocity.  Formulation 11, step 5.
    void carry_body_nodes(const Model& model);

    std::vector<NodeConditions> conditions;
    std::vector<int> body;               ///< of each node, -1: none
    std::vector<Vec3> start;             ///< x_0, after Inacti 3 [length]
    std::vector<Vec3> position;          ///< x_n [length]
    std::vector<Vec3> velocity;          ///< v_{n-1/2} [velocity]
    std::vector<Vec3> acceleration;      ///< [length/time^2]
    std::vector<Vec3> displacement;      ///< x_n - x_0 [length]
    std::vector<Vec3> angular_velocity;  ///< of the node's body, else 0 [1/time]
    std::vector<Vec3> reaction;          ///< REAC, cumulative impulse [force time]
    std::vector<Vec3> reaction_moment;   ///< [moment time]
    std::vector<BodyState> bodies;
    std::vector<double> thickness;  ///< of each shell at the end of the cycle before; empty while none changes [length]
    std::vector<double> temperature;  ///< of each node; empty in a scene without heat [temperature]

    std::vector<SensorState> sensors;        ///< like Model::sensors, at t_n
    std::vector<InterfaceForce> last_force;  ///< of each interface in the cycle before [force]

    double time = 0;           ///< t_n [time]
    double step = 0;           ///< dt1 [time]
    double weight_before = 0;  ///< (dt1 + dt2)/2 of the cycle before [time]
    long cycle = 0;            ///< n

    /// What a contact may know of this cycle. Its spans point into this state.  Formulation 11, step 1.
    Motion motion(const HostReading& reading) const;
    /// Brings the sensors to t_n.  Formulation 9, step 2.
    void update_sensors(const Model& model);
    /// Gives the nodes of /IMPTEMP their temperature of t_n; nothing in a scene without heat.
    void impose_temperatures(const Model& model);
};

}  // namespace type21
