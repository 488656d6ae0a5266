/// @file Stops a run whose energy grows beyond what was put in (Formulation 11, step 12).
#pragma once

#include <vector>

#include "reference/contract/contact_step.h"
#include "reference/host/integrate.h"
#include "reference/host/state.h"

namespace type21 {

/// Energy that may appear from nowhere, as a fraction of the largest energy put in, where /STOP gives none. One bounce
/// of a free mass at the stability limit makes up to twice its energy; a step beyond the limit makes more each time.
inline constexpr double default_energy_limit = 10.0;

/// Energies since the start. Plain data: part of the state of a run.
struct EnergyAccount {
    double put_in = 0;       ///< kinetic energy of time 0, work of loads and drives, what appears with an interface
    double most_put_in = 0;  ///< the largest put_in so far
    double dissipated = 0;   ///< work of friction, contact damping and tool damping
    double kinetic = 0;      ///< of v_{n+1/2}
    double elastic = 0;      ///< of the contacts of cycle n

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(put_in, most_put_in, dissipated, kinetic, elastic);
    }

    double found() const { return kinetic + elastic + dissipated; }
};

/// What is remembered of a secondary node that touches. Plain data: part of the state of a run.
struct TouchMemory {
    double energy = 0;    ///< elastic energy [energy]
    double force = 0;     ///< elastic force [force]
    double distance = 0;  ///< delta [length]
    bool touches = false;

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(energy, force, distance, touches);
    }
};

/// Balances the energy of a scene in which something is free to move; does nothing in any other.
class EnergyWatch {
  public:
    EnergyWatch(const Model& model, const HostState& start);

    /// Adds cycle n.
    /// @param state   of cycle n
    /// @param next    behind it
    /// @param forces  of cycle n
    /// @param steps   the contacts of cycle n
    /// @throws RunStopped when the energy found exceeds the energy put in by more than the limit
    void add(const HostState& state, const HostState& next, const CycleForces& forces,
             const std::vector<ContactStep>& steps);

    const EnergyAccount& account() const { return account_; }

    /// What a checkpoint holds: all that is not of the scene.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(account_, touched_, was_active_);
    }

  private:
    double kinetic(const HostState& state) const;
    double work_put_in(const HostState& state, const HostState& next, const CycleForces& forces) const;
    double dissipated(const HostState& state, const HostState& next, const std::vector<ContactStep>& steps) const;
    double appeared(const std::vector<ContactStep>& steps);
    void judge(const HostState& state) const;

    const Model& model_;
    bool watches_ = false;
    double limit_ = default_energy_limit;
    EnergyAccount account_;
    std::vector<std::vector<TouchMemory>> touched_;  ///< per interface and secondary node
    std::vector<char> was_active_;                   ///< per interface, 0 or 1
};

}  // namespace type21
