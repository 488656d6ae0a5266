/// @file Balance of forces, power and energies of a contact, checked in every cycle from the ContactStep only.
#pragma once

#include <string_view>
#include <vector>

#include "reference/host/march.h"

namespace type21 {

/// The largest residual of a run, relative to the sum of the absolute terms of its cycle.
struct Residual {
    double relative = 0;  ///< [-]
    long cycle = -1;      ///< where; -1: every residual was 0
    double time = 0;      ///< [time]
};

template <class Archive>
void visit_state(Archive& archive, Residual& residual) {
    auto& [relative, cycle, time] = residual;
    archive(relative, cycle, time);
}

/// With f the force on a node, X its contact point, V + Omega x (X - x_G) the tool's velocity there, v_rel the node's
/// relative to it:
///   force    sum f + (sums.normal + sums.tangential) = 0
///   power    sum <f, v> - <sum f, V> - <sum (X - x_G) x f, Omega> = sum F v_n - sum C v_n^2 - sum <F_t, v_rel>
///   damping  CE_DAMP = sum over the cycles of C v_n^2 dt1
///   friction CE_FRIC + QFRIC = sum over the cycles of <v_rel, F_t> dt1
///   heat     sum C dT = sum of the heat given, over the nodes with a heat capacity and all interfaces together
/// The node's force acts at x, the tool's at X: each enters the power with its own velocity, so the identity holds to
/// rounding. Source: Formulation 7, step 7; Formulation 8, step 12.
struct InterfaceBalance {
    Residual force, power, damping_energy, friction_energy, heat;
    long cycles_in_contact = 0;  ///< cycles with a force on a node: 0: nothing was checked
};

template <class Archive>
void visit_state(Archive& archive, InterfaceBalance& balance) {
    auto& [force, power, damping_energy, friction_energy, heat, cycles_in_contact] = balance;
    archive(force, power, damping_energy, friction_energy, heat, cycles_in_contact);
}

/// The residual that a case calls "force", "power", "CE_DAMP", "CE_FRIC" or "heat"; nullptr for another name.
const Residual* find_residual(const InterfaceBalance& balance, std::string_view name);

class BalanceObserver {
  public:
    explicit BalanceObserver(const HostScene& scene);

    void observe(const CycleRecord& record);
    /// Per interface.
    const std::vector<InterfaceBalance>& result() const { return balance_; }
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(balance_, energies_);
    }

  private:
    struct Energies {
        double damping = 0, damping_terms = 0;
        double friction = 0, friction_terms = 0;

        template <class Archive>
        void visit_state(Archive& archive) {
            archive(damping, damping_terms, friction, friction_terms);
        }
    };

    void observe_heat(const CycleRecord& record);

    const Model& model_;
    std::vector<InterfaceBalance> balance_;
    std::vector<Energies> energies_;
};

}  // namespace type21
