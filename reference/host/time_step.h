/// @file The step that follows a cycle (Formulation 11, step 3).
#pragma once

#include <vector>

#include "reference/contract/contact_step.h"
#include "reference/host/state.h"
#include "reference/host/thermal_limit.h"

namespace type21 {

/// What the limits of the step are; infinite where nothing limits.
struct StepLimits {
    double nodal = 0;           ///< scale * sqrt(2 m / K) over nodes and tools [time]
    double kinematic = 0;       ///< 0.9 c / v_max over the interfaces [time]
    double thermal = 0;         ///< of ThermalLimit [time]
    double thermal_stable = 0;  ///< above it temperatures grow; not scaled [time]
};

/// sqrt(2 m / K) [time]; infinite without mass or stiffness.
double stable_step(double mass, double stiffness);
/// Of a tool with its damping: K (sqrt(1 + a^2) + a)^2 in place of K, a = C / sqrt(4 M K) [time].
double damped_step(double inertia, double stiffness, double damping);

/// Remembers the smallest c of each interface.
class TimeStep {
  public:
    explicit TimeStep(const HostScene& scene);

    /// dt2 after the contact of cycle n: the constant step of /DTIX when its two values are equal; else the first value
    /// in the first cycle, and then the least of the nodal, the kinematic and the thermal limit, the second value of
    /// /DTIX and the /TFILE interval.
    /// @param contacts  of cycle n, one for each interface
    /// @return dt2 [time]; infinite where nothing limits it, which the caller must refuse.  Formulation 11, step 3.
    double next(const HostState& state, const std::vector<ContactStep>& contacts);

    /// Limits of the last call of next().
    const StepLimits& limits() const { return limits_; }

    /// What a checkpoint holds: all that is not of the scene or of the last call.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(reach_);
    }

  private:
    double nodal_limit(const HostState& state, const std::vector<ContactStep>& contacts) const;
    double kinematic_limit(const HostState& state, const std::vector<ContactStep>& contacts);

    HostScene scene_;
    ThermalLimit thermal_;
    std::vector<double> reach_;    ///< smallest c so far, per interface [length]
    std::vector<Vec3> farthest_;   ///< main node farthest from x_G, in the tool frame, per interface [length]
    std::vector<double> inertia_;  ///< smallest principal inertia of the tool, per interface [mass length^2]
    StepLimits limits_;
};

}  // namespace type21
