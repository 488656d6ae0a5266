/// @file The march: explicit time integration of a HostScene (formulation section 11).
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

/// Impulses on the tool and energies of one interface since the start; the columns of the time history.
struct InterfaceTotals {
    Vec3 normal = Vec3::Zero();
    Vec3 tangential = Vec3::Zero();
    Vec3 abs_normal = Vec3::Zero();
    double signed_normal = 0;
    Vec3 abs_total = Vec3::Zero();
    double norm_total = 0;
    double friction_heat = 0;
    double elastic_energy = 0;  ///< of this cycle
    double friction_energy = 0;
    double damping_energy = 0;
    double heat_to_blank = 0;
    double heat_to_tool = 0;
};

/// What is known at the end of cycle n: x_n, v_{n-1/2} and the sums including cycle n.
struct CycleRecord {
    long cycle = 0;
    double time = 0;
    double step = 0;       ///< dt1
    double next_step = 0;  ///< dt2
    const Motion* motion = nullptr;
    const std::vector<ContactStep>* contacts = nullptr;  ///< one for each interface
    const std::vector<InterfaceTotals>* totals = nullptr;
    const std::vector<Vec3>* displacement = nullptr;      ///< per node, x_n - x_0
    const std::vector<Vec3>* angular_velocity = nullptr;  ///< per node: that of its rigid body, else 0
    const std::vector<Vec3>* acceleration = nullptr;      ///< per node
    const std::vector<Vec3>* reaction = nullptr;          ///< per node, cumulative impulse REAC
    const std::vector<Vec3>* reaction_moment = nullptr;   ///< per node
    const std::vector<double>* temperature = nullptr;     ///< per node, after the heat of the cycle; empty without heat
    const std::vector<std::unique_ptr<ContactMethod>>* methods = nullptr;  ///< who computed them: stage_counts, rooms
    bool last = false;
};

using Observer = std::function<void(const CycleRecord&)>;
using MakeContact = std::function<std::unique_ptr<ContactMethod>(const Scene&, int interface)>;

/// A run that cannot go on: NaN, an infinite or vanishing step, or Invn.
struct RunStopped : std::runtime_error {
    enum class Why { diverged, inverted_normal, step_too_small };
    RunStopped(Why why_, const std::string& message) : std::runtime_error(message), why(why_) {}
    Why why;
};

/// What a run may be given beside its scene.
struct MarchOptions {
    const ThicknessHistory* thickness = nullptr;  ///< of the shells over time, for Igap 2 and Idel
};

/// Runs the scene to its end time. observe is called once a cycle, before the next one starts.
/// @throws RunStopped naming node, cycle and time; what was observed so far stays valid.
void march(const HostScene& scene, const MakeContact& make_contact, const Observer& observe,
           const MarchOptions& options = {});

}  // namespace type21
