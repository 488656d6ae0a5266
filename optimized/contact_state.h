/// @file What an optimized contact holds.
#pragma once

#include <optional>
#include <tbb/enumerable_thread_specific.h>

#include "optimized/contact.h"
#include "optimized/kernel/adaptive_law.h"
#include "optimized/kernel/contact_point.h"
#include "optimized/kernel/node_data.h"
#include "optimized/search/sorted/candidate_lists.h"

namespace type21::optimized {

inline constexpr int chunk = Search::Batch::capacity;  ///< nodes that one thread takes at a time

struct Contact::State {
    State(const Scene& scene, int interface, const ContactOptions& options);

    /// Inacti 1, 5, 6: the histories of time 0.
    void start(const Motion& motion);
    /// Gaps of this cycle (Igap 2). A new search is built when they exceed the limits of the old one.
    void update_gaps(const Motion& motion, ContactStep& step);
    void new_search();
    /// The impact that decides Inacti and the list of initial penetrations; with D31 by another projection.
    struct StartImpact {
        double penetration = 0;
        Retained retained;
        ContactPoint point;
    };
    /// Of all secondary nodes. @param position  of each node of the model
    std::vector<StartImpact> impacts_at_start(std::span<const Vec3> position, const ToolMotion& pose) const;
    /// @param start  the lists of these positions, with the sorted search
    StartImpact impact_at_start(size_t i, std::span<const Vec3> position, const ToolMotion& pose,
                                const CandidateLists* start) const;
    /// Of all secondary nodes, in the tool frame.
    std::vector<V3> in_tool_frame(std::span<const Vec3> position, const ToolMotion& pose) const;
    V3 in_tool_frame(size_t i, std::span<const Vec3> position, const ToolMotion& pose) const {
        // The operations of the kernels: their rounding is part of the position that decisions are exact for.
        return from(pose.rotation.transpose() * (position[static_cast<size_t>(nodes.node[i])] - pose.position));
    }
    /// The sorted search: new lists where a node has left what its list covers.
    void keep_lists(const Motion& motion);
    /// Runs the kernel over all nodes.
    void run(const Motion& motion, const Output& out);
    ContactSums sums() const;
    ToolLoad tool_load(const Motion& motion) const;
    double inertia_of(const Vec3& spin, const ToolMotion& pose) const;
    bool active(const Motion& motion) const;
    bool has(Effect effect) const { return scene.has(interface, effect); }

    Scene scene;
    int interface;
    ContactOptions options;
    Laws laws;
    NodeData nodes;
    double largest_reach;  ///< CaptureLimits::outward of the search [length]
    Kernel one_by_one;
    double least_inertia = 0;  ///< smallest principal inertia of the tool [mass length^2]
    bool started = false;
    int inacti;  ///< as it acts; with D26 it becomes 0 when nothing penetrates at time 0
    std::optional<AdaptiveLaw> adaptive;

    tbb::enumerable_thread_specific<Workspace> work;
    std::unique_ptr<CandidateLists> candidates;  ///< of the sorted search, else none
    long sorts = 0, cycles = 0;                  ///< of the sorted search
    std::vector<ChunkLists> lists;               ///< one a chunk
    StepSums total;
    PathCounts counts;
    ExclusiveRegionPolicy exclusive_region_policy;
    LeanStep lean;
    std::vector<Vec3> lean_force;
    std::vector<double> lean_stiffness;

    /// What the next cycle needs of the past, but for the nodes. Every field is named here: one that is added later
    /// does not compile until it is decided whether it belongs to a checkpoint. The lists of the sorted search are made
    /// anew.
    template <class Archive>
    static void visit(Archive& archive, State& state) {
        auto& [the_scene, number, choice, the_laws, node, reach, kernel, inertia, has_started, inacti_now, law, storage,
               candidate_lists, sorted, sorted_cycles, chunks, sum, paths, policy, lean_step, force, stiffness] = state;
        archive(reach, has_started, inacti_now, sorted, sorted_cycles, paths, policy);
    }
};

}  // namespace type21::optimized
