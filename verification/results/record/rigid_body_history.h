/// @file The rows of rbody.csv: motion of the tools and the impulses that the contacts give them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reference/host/march.h"

namespace type21 {

/// Follows the bodies that /TH/RBODY names, else the tool of every interface.
/// FX .. MZ are the impulses of ToolLoad (contact and tool damping), moments about the main node, with the weight
/// w = (dt1 + dt2)/2 of every impulse (Formulation 11, step 7). OpenRadioss leaves these columns 0 for TYPE21 (measured
/// run, commit bd4557b), so they are compared with nothing.
class RigidBodyHistory {
  public:
    explicit RigidBodyHistory(const HostScene& scene);

    /// Every cycle, recorded or not: impulses are sums over all of them.
    void add(const CycleRecord& record);

    static const std::vector<std::string>& header();
    const std::vector<int>& bodies() const { return bodies_; }
    /// Values of one body in the order of header() after `time,rbody`.
    std::vector<double> values(const CycleRecord& record, size_t body) const;
    template <class Archive>
    void visit_state(Archive& archive) {
        for (auto& [force, moment] : impulse_)
            archive(force, moment);
    }

  private:
    const Model& model_;
    std::vector<int> bodies_;                   ///< index into Model::rigid_bodies, ascending
    std::vector<std::array<Vec3, 2>> impulse_;  ///< force [impulse] and moment [impulse length], like bodies_
};

}  // namespace type21
