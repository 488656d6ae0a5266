/// @file The march: explicit time integration of a HostScene (Formulation 11, step 2).
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/contract/contact_method.h"
#include "reference/contract/motion.h"
#include "reference/host/thickness_history.h"
#include "reference/model/host_scene.h"

namespace type21 {

/// Impulses on the tool and energies of one interface since the start; the columns of the time history. What each sums
/// is said in ContactSums.  Formulation 11, step 8.
struct InterfaceTotals {
    Vec3 normal = Vec3::Zero();      ///< of the normal force on the tool [force time]
    Vec3 tangential = Vec3::Zero();  ///< of the friction force on the tool [force time]
    Vec3 abs_normal = Vec3::Zero();  ///< of the absolute components of the normal force [force time]
    double signed_normal = 0;        ///< of -F_n [force time]
    Vec3 abs_total = Vec3::Zero();   ///< of the absolute components of the whole force [force time]
    double norm_total = 0;           ///< of the norm of the whole force of each node [force time]
    double friction_heat = 0;        ///< QFRIC: friction heat [energy]
    double elastic_energy = 0;       ///< CE_ELAST: that of this cycle, not a sum over time [energy]
    double friction_energy = 0;      ///< CE_FRIC: work of friction less friction_heat [energy]
    double damping_energy = 0;       ///< CE_DAMP: work of the contact damping [energy]
    double heat_to_blank = 0;        ///< all heat to nodes of the blank, friction heat included [energy]
    double heat_to_tool = 0;         ///< all heat to tool nodes [energy]
};

/// What is known at the end of cycle n: x_n, v_{n-1/2} and the sums including cycle n. The pointers are valid only
/// during the call of the observer and are never null there; vectors of nodes are indexed like Model::nodes.
/// Formulation 11, step 10.
struct CycleRecord {
    long cycle = 0;                                        ///< n, from 0
    double time = 0;                                       ///< t_n [time]
    double step = 0;                                       ///< dt1, 0 in the first cycle [time]
    double next_step = 0;                                  ///< dt2 [time]
    const Motion* motion = nullptr;                        ///< what the contacts were given
    const std::vector<ContactStep>* contacts = nullptr;    ///< one for each interface
    const std::vector<InterfaceTotals>* totals = nullptr;  ///< one for each interface
    const std::vector<Vec3>* displacement = nullptr;       ///< per node, x_n - x_0 [length]
    const std::vector<Vec3>* angular_velocity = nullptr;   ///< per node: that of its rigid body, else 0 [1/time]
    const std::vector<Vec3>* acceleration = nullptr;       ///< per node [length/time^2]
    const std::vector<Vec3>* reaction = nullptr;           ///< per node, cumulative impulse REAC [force time]
    const std::vector<Vec3>* reaction_moment = nullptr;    ///< per node, cumulative [moment time]
    const std::vector<double>* temperature =
        nullptr;  ///< per node, after the heat of the cycle; empty without heat [temperature]
    const std::vector<std::unique_ptr<ContactMethod>>* methods =
        nullptr;        ///< the contacts themselves, for their counts and memory
    bool last = false;  ///< no cycle follows
};

/// Called once a cycle.
using Observer = std::function<void(const CycleRecord&)>;
/// reference::make_contact, optimized::make_contact or another.
using MakeContact = std::function<std::unique_ptr<ContactMethod>(const Scene&, int interface)>;

/// A run that cannot go on: a number that is not finite, energy from nowhere, an infinite or vanishing step, a step
/// below that of /DT, or Invn; or one that was told not to.
struct RunStopped : std::runtime_error {
    enum class Why { diverged, inverted_normal, step_too_small, interrupted };
    RunStopped(Why why_, const std::string& message) : std::runtime_error(message), why(why_) {}
    Why why;
};

/// A moment between two cycles.
struct BetweenCycles {
    long next_cycle = 0;                            ///< n of the cycle that follows
    double time = 0;                                ///< its t_n [time]
    const std::function<void(StateWriter&)>& save;  ///< writes what the cycles that follow need of those before
};

/// What a run may be given beside its scene.
struct MarchOptions {
    const ThicknessHistory* thickness = nullptr;  ///< of the shells over time, for Igap 2 and Idel
    /// Called after each cycle that another one follows. It may throw RunStopped to end the run there.
    std::function<void(const BetweenCycles&)> between_cycles{};
    /// What BetweenCycles::save wrote in a run of the same scene, contacts and thickness: the run goes on there, and
    /// every later cycle has the same bits. Null: from time 0.
    StateReader* restart = nullptr;
    /// What a user should know of the run as a whole: steps above the stability limit, a run of very many cycles. Each
    /// is said once, however the run ends. May be empty; must not throw.
    std::function<void(const std::string&)> warn{};
};

/// Runs the scene to its end time. observe is called once a cycle, before the next one starts.
/// @param scene  of a deck that check_runnable() accepts
/// @throws RunStopped naming node, cycle and time; what was observed so far stays valid. StateError when the state of
/// options.restart is not one of this scene. Whatever make_contact, observe or between_cycles throws is passed on.
/// Formulation 11, step 2.
void march(const HostScene& scene, const MakeContact& make_contact, const Observer& observe,
           const MarchOptions& options = {});

}  // namespace type21
