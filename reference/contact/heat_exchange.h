/// @file Heat exchange of the nodes of one interface (Formulation 9, step 4 to step 11).
#pragma once

#include <vector>

#include "reference/contact/contact_reading.h"
#include "reference/contract/decision.h"
#include "reference/contract/scene.h"

namespace type21::reference {

/// Conductivity of the blank: k_s(T) = A_S + B_S T.  Formulation 9, step 7.
struct Conductivity {
    double a = 0;  ///< A_S [power/(length temperature)]
    double b = 0;  ///< B_S [power/(length temperature^2)]

    /// @param temperature  T [temperature]
    /// @return k_s [power/(length temperature)]
    double at(double temperature) const { return a + b * temperature; }
};

/// What the heat needs to know of a node.
struct HeatInput {
    double distance = 0;           ///< delta, signed [length]
    double gap = 0;                ///< g [length]
    double normal_force = 0;       ///< F_n [force]
    double step = 0;               ///< dt1 [time]
    double blank_temperature = 0;  ///< T_s [temperature]
    double tool_temperature = 0;   ///< T_m [temperature]
};

/// Heat of one node in one cycle.
struct HeatFlow {
    double heat = 0;                 ///< Phi, to the node [energy]
    double conductance = 0;          ///< A / (...) of the conduction [power/temperature]
    double radiant_conductance = 0;  ///< A h_r of the radiation [power/temperature]
};

/// Parameters and conductivities of the heat exchange. Present only with Ithe. Node i is the rank in
/// SecondarySide::node; it is not checked.
/// @manual field Ithe; comment 16
class HeatExchange {
  public:
    /// @param reading  zones and conductance beyond the gap, as documented or as built
    HeatExchange(const ContactModel& model, const Interface& interface, const ContactReading& reading);

    /// Heat of node i in this cycle, friction heat not included; nothing outside of every zone.
    /// Formulation 9, step 6 to step 9.
    HeatFlow flow(int i, const HeatInput& input) const;
    /// The tool's temperature is that of its nodes, and not Tint.  Formulation 9, step 4.
    /// @manual field Ithe, Ithe_form, Tint
    bool tool_has_temperatures() const { return interface_.ithe == 2 || interface_.ithe_form == 1; }
    /// The tool is heated as well.  Formulation 9, step 11.
    /// @manual field Ithe_form
    bool heats_tool() const { return interface_.ithe_form == 1; }

    static constexpr size_t bytes_per_node() { return sizeof(Conductivity); }

    /// K at a contact pressure, equation (15).
    /// @param pressure  |F_n| / A [pressure]
    /// @return K [power/(area temperature)].  Formulation 9, step 7.
    /// @manual eq 15; field Kthe, fct_IDK, AscaleK
    double exchange(double pressure) const;
    /// k_s of the blank at node i.
    const Conductivity& conductivity(int i) const { return conductivity_[static_cast<size_t>(i)]; }

  private:
    const ContactModel& model_;
    const Interface& interface_;
    const ContactReading& reading_;
    std::vector<Conductivity> conductivity_;  ///< at each node, mean over its shells weighed with their area there
};

}  // namespace type21::reference
