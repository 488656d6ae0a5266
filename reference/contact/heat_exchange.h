/// @file Heat between blank and tool (page comments 16 to 18, 22, 23, equations (14) to (20); formulation section 9).
#pragma once

#include <vector>

#include "reference/contract/decision.h"
#include "reference/contract/scene.h"

namespace type21::reference {

/// k_s(T) = A_S + B_S T
struct Conductivity {
    double a = 0;  ///< A_S [power/(length temperature)]
    double b = 0;  ///< B_S [power/(length temperature^2)]

    double at(double temperature) const { return a + b * temperature; }
};

/// Which of the zones a node is in, by its distance d = max(delta, 0).
struct HeatZones {
    bool conduction = false;  ///< d <= g
    bool distance = false;    ///< g < d <= Dcond, Fcond given
    bool radiation = false;   ///< g < d <= Drad, Frad given

    bool any() const { return conduction || distance || radiation; }
};

/// @param distance  d = max(delta, 0) [length]
/// @param gap       g [length]
/// @manual eq 16; field Drad, Dcond; comment 17, 23; departure D15
HeatZones heat_zones(const Interface& interface, double distance, double gap, const AsBuilt& as_built);

/// Conductance of the gap, per area:  1 / (d/k_s + 1/K), equation (14); 0 where K or the conductivity is 0.
/// @param exchange      K, Kthe or Kthe f_K(AscaleK |F_n| / A), equation (15) [power/(area temperature)]
/// @param distance      d [length]
/// @param conductivity  k_s of the blank [power/(length temperature)]
/// @manual eq 14; field Kthe; comment 16
double conduction_conductance(double exchange, double distance, double conductivity);

/// Beyond the gap: K f in series with the sheet over g, f = f_cond((d - g)/(Dcond - g)), equation (20).
/// D32: f multiplies the whole conductance of the gap.
/// @manual eq 20; field Fcond, Dcond; comment 22; departure D32
double distance_conductance(double exchange, double share, double gap, double conductivity, const AsBuilt& as_built);

/// Radiated power per area: Frad (T_m^4 - T_s^4), equation (17).
/// @manual eq 17; field Frad; comment 17
double radiated(double frad, double tool_temperature, double blank_temperature);

/// What the heat needs to know of a node.
struct HeatInput {
    double distance = 0;           ///< delta, signed [length]
    double gap = 0;                ///< g [length]
    double normal_force = 0;       ///< F_n [force]
    double step = 0;               ///< dt1 [time]
    double blank_temperature = 0;  ///< T_s
    double tool_temperature = 0;   ///< T_m
};

/// Heat of one node in one cycle.
struct HeatFlow {
    double heat = 0;         ///< Phi, to the node [energy]
    double conductance = 0;  ///< A / (...), for the thermal step [power/temperature]
};

/// The room of heat exchange: parameters and conductivities. Present only with Ithe.
/// @manual field Ithe; comment 16
class HeatExchange {
  public:
    HeatExchange(const ContactModel& model, const Interface& interface);

    HeatFlow flow(int i, const HeatInput& input) const;
    /// The tool's temperature is that of its nodes, and not Tint.
    /// @manual field Ithe, Ithe_form, Tint
    bool tool_has_temperatures() const { return interface_.ithe == 2 || interface_.ithe_form == 1; }
    /// The tool is heated as well.
    /// @manual field Ithe_form; departure D16
    bool heats_tool() const { return interface_.ithe_form == 1; }

    static constexpr size_t bytes_per_node() { return sizeof(Conductivity); }

    /// K at a contact pressure [power/(area temperature)], equation (15).
    /// @manual eq 15; field Kthe, fct_IDK, AscaleK
    double exchange(double pressure) const;
    /// k_s of the blank at secondary node i.
    const Conductivity& conductivity(int i) const { return conductivity_[static_cast<size_t>(i)]; }

  private:
    const ContactModel& model_;
    const Interface& interface_;
    std::vector<Conductivity>
        conductivity_;  ///< of the blank at each node, mean over its shells weighed with their area there
};

}  // namespace type21::reference
