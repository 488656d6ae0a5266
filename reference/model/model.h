/// @file The Model: what a deck means, every default resolved: what the contact sees, and what drives it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reference/contract/scene.h"
#include "reference/model/motion_conditions.h"
#include "reference/model/sensor.h"
#include "reference/model/units.h"

namespace type21 {

/// What /TH asks for: variables by their Radioss names and the objects by id (interfaces, rigid bodies) or index
/// (nodes).
struct HistoryRequest {
    enum class Kind { interface, node, rigid_body };
    Id id = 0;
    std::string title;
    Kind kind = Kind::interface;
    std::vector<std::string> variables;  ///< expanded: DEF and groups such as D become DX, DY, DZ
    std::vector<int> objects;            ///< index into Model::interfaces, nodes or rigid_bodies
};

/// The engine deck.
struct EngineControl {
    std::string run_name;
    double end_time = 0;                 ///< /RUN [time]
    double history_interval = 0;         ///< /TFILE [time]; 0: every cycle
    std::optional<double> first_step;    ///< /DTIX, first value [time]
    std::optional<double> largest_step;  ///< /DTIX, second value [time]
    bool nodal_step = false;             ///< /DT/NODA
    double step_scale = 0.9;             ///< /DT/NODA scale factor [-]
    double smallest_step = 0;            ///< /DT/NODA[/STOP]: the run stops below it [time]
    std::optional<double> energy_limit;  ///< /STOP, Emax: energy from nowhere over the energy put in [-]
};

/// All of a deck. What the contact may see of it is the base; the rest is for the host and the histories.
struct Model : ContactModel {
    std::string deck_path;
    std::string run_name;
    std::string title;
    int version = 2025;                 ///< of /BEGIN
    UnitSystem input_units;             ///< of /BEGIN: those in which the deck is written
    UnitSystem units;                   ///< work units of /BEGIN: those of every number in the Model
    std::map<Id, UnitSystem> unit_ids;  ///< /UNIT

    std::vector<Property> properties;
    std::vector<NodeGroup> groups;
    std::vector<Skew> skews;        ///< /SKEW/FIX, then /FRAME/FIX
    std::vector<Sensor> sensors;    ///< Interface::sensor is an index into these
    std::vector<int> sensor_order;  ///< those that something uses; a sensor stands behind those it looks at
    std::vector<BoundaryCondition> boundary_conditions;
    std::vector<ImposedMotion> imposed_motions;
    std::vector<InitialVelocity> initial_velocities;
    std::vector<ConcentratedLoad> loads;
    std::vector<Gravity> gravities;
    std::vector<AddedMass> added_masses;
    std::vector<InitialTemperature> initial_temperatures;
    std::vector<ImposedTemperature> imposed_temperatures;
    std::vector<HistoryRequest> histories;
    EngineControl engine;

    std::vector<double> nodal_mass;  ///< lumped shell mass and added masses, per node [mass]
    std::vector<double>
        nodal_heat_capacity;  ///< rho Cp with the shares of the mass; empty without /HEAT/MAT [energy/temperature]
};

}  // namespace type21
