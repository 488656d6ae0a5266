/// @file The optimized contact: the same constructor, the same step and the same decisions as the reference.
#pragma once

#include <memory>

#include "optimized/search/path_tally.h"
#include "reference/contract/contact_method.h"

namespace type21::optimized {

/// What the time integration needs of a cycle. A full ContactStep writes 400 bytes a node.
struct LeanStep {
    bool active = false;
    std::span<const Vec3> force;             ///< on each secondary node [force]; empty while inactive
    std::span<const double> step_stiffness;  ///< k + C/dt1 [force/length]
    ContactSums sums;
    ToolLoad tool;
};

/// Counts of how decisions were reached since the start.
struct PathCounts : PathTally {
    long nodes = 0;  ///< of all cycles
};

/// Threads: as many as the TBB arena that calls step has; the result is the same bits for any number.
class Contact final : public ContactMethod {
  public:
    Contact(const Scene& scene, int interface);
    ~Contact() override;

    ContactStep step(const Motion& motion) override;
    void step_into(const Motion& motion, ContactStep& into) override;
    /// The same cycle without the per-node report. Lists of released and inverted nodes, heat and adaptive data are in
    /// the full step only.
    /// @throws std::logic_error for a scene with one of these
    const LeanStep& step_lean(const Motion& motion);

    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override;
    std::vector<EffectMemory> memory_by_effect() const override;
    DecisionStageCounts decision_stage_counts() const override;

    PathCounts paths() const;
    /// Bytes that the tool and its search hold, and those per secondary node.
    size_t tool_bytes() const;
    size_t bytes_per_node() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace type21::optimized
