/// @file Heat between blank and tool (Formulation 9, steps 4 to 12).
#pragma once

#include <vector>

#include "reference/contract/scene.h"

namespace type21::optimized {

/// Heat of one node in one cycle.
struct Heat {
    double to_node = 0;      ///< Phi [energy]
    double conductance = 0;  ///< A / (d/k_s + 1/K) [power/temperature]
    double radiant = 0;      ///< A Frad (T_m^2 + T_s^2)(T_m + T_s) [power/temperature]
};

/// Parameters of the card, and the conductivity of the blank at each node: the mean over its thermal shells, weighed
/// with a quarter (a third for a triangle) of their areas.
/// @manual eq 14, 15, 16, 17, 20; field Ithe, Kthe, fct_IDK, AscaleK, Frad, Drad, Fcond, Dcond; comment 16, 17, 22, 23
/// @manual departure D15, D32, D38
class HeatLaw {
  public:
    HeatLaw(const ContactModel& model, const Interface& interface);

    /// @param node      rank of the secondary node      @param distance  delta, signed [length]
    /// @param force     F_n [force]                     @param blank, tool  T_s, T_m   @param step  dt1 [time]
    Heat operator()(int node, double distance, double gap, double force, double blank, double tool, double step) const;

    /// The tool's temperature is that of its nodes.
    bool nodal_tool() const { return nodal_tool_; }
    /// The tool is heated, too.
    bool heats_tool() const { return heats_tool_; }
    static constexpr size_t bytes_per_node() { return 2 * sizeof(double); }

  private:
    double exchange(double pressure) const;

    const Interface& card_;
    const std::vector<double>& area_;
    const Function* of_pressure_ = nullptr;
    const Function* of_distance_ = nullptr;
    bool nodal_tool_, heats_tool_, d15_, d32_, d38_;
    struct Conductivity {
        double a = 0, b = 0;  ///< k_s = a + b T
    };
    std::vector<Conductivity> conductivity_;
};

}  // namespace type21::optimized
