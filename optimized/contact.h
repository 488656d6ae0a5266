/// @file The optimized contact: the same constructor, the same step and the same decisions as the reference.
#pragma once

#include <memory>
#include <optional>

#include "optimized/search/path_tally.h"
#include "optimized/search/search_kind.h"
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

    template <class Archive>
    void visit_state(Archive& archive) {
        PathTally::visit_state(archive);
        archive(nodes);
    }
};

/// What there is to choose beside the scene. No choice changes a decision or a force.
struct ContactOptions {
    SearchKind search = SearchKind::tree;
    double bumult = 0;  ///< instead of that of the card, with the sorted search; 0: that of the card [-]
};

/// What the sorted search did since the start.
struct SortedSearchCounts {
    double margin = 0;    ///< how far a node may move before all are sorted again [length]
    long cycles = 0;      ///< in which nodes were searched for
    long sorts = 0;       ///< in how many of these cycles all nodes were sorted
    long searches = 0;    ///< nodes that were searched for, over all cycles
    long candidates = 0;  ///< segments in their lists
    long near = 0;        ///< of these, segments whose boxes held the node: they were projected on
    size_t bytes = 0;     ///< of the lists of the last sort [byte]

    double candidates_per_node() const { return share(candidates, searches); }
    double near_per_node() const { return share(near, searches); }

  private:
    static double share(long part, long of) { return of > 0 ? static_cast<double>(part) / static_cast<double>(of) : 0; }
};

/// Threads: as many as the TBB arena that calls step has; the result is the same bits for any number.
class Contact final : public ContactMethod {
  public:
    Contact(const Scene& scene, int interface, const ContactOptions& options = {});
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
    void save(StateWriter& out) const override;
    void restore(StateReader& in) override;

    PathCounts paths() const;
    /// Empty with the tree.
    std::optional<SortedSearchCounts> sorted_search() const;
    /// Bytes that the tool and its search hold, and those per secondary node.
    size_t tool_bytes() const;
    size_t bytes_per_node() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// As make_contact of the contract (make_contact.h), with a choice.
std::unique_ptr<ContactMethod> make_contact(const Scene& scene, int interface, const ContactOptions& options);

}  // namespace type21::optimized
