/// @file The thermal limit of the time step (Formulation 11, step 3).
#pragma once

#include <vector>

#include "reference/contract/contact_step.h"
#include "reference/host/state.h"

namespace type21 {

/// A step above `stable`, which the deck may force, makes temperatures grow:
///   2 C / (G_f + 2 G_m),
/// G_f: conductances to what keeps its temperature, a tool that is not heated; G_m: those to nodes that do not, heated
/// tool and inside of the sheet. As they are in this cycle (Gershgorin's bound on the largest decay rate).
struct ThermalLimits {
    double step = 0;    ///< of the engine's own step [time]; infinite where no heat flows
    double stable = 0;  ///< likewise
};

/// How long a step may be so that heat does not overshoot:
///   min(s 2 C/G_c, 0.9 C/G)
/// over the nodes that hold heat. C: heat capacity of the node. G_c: conduction between tool and node of the blank
/// alone; s: scale factor of the engine deck. The first term is that of Radioss. G: all that exchanges heat with the
/// node, that is conduction and radiation of the contact, on the blank and on a heated tool, and the inside of the
/// sheet. With a step of C/G the new temperature of a node is a mean of temperatures that were there before.
class ThermalLimit {
  public:
    explicit ThermalLimit(const Model& model);

    /// @param scale     s [-]
    /// @param contacts  of this cycle, one for each interface
    ThermalLimits operator()(const HostState& state, const std::vector<ContactStep>& contacts, double scale) const;

  private:
    const Model& model_;
    /// Conductance of each node that touches the tool at the highest point of f_K, A Kthe max f_K, by interface and
    /// rank. A step acts one cycle after it was chosen, so a node may touch, or be pressed, in between
    /// [power/temperature].
    std::vector<std::vector<double>> touching_;
    std::vector<double> largest_touching_;  ///< of those, by interface [power/temperature]
};

}  // namespace type21
