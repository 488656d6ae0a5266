/// @file A step put together by hand, from the product's parts, for one kind of scene: elastic, or elastic with damping
/// and Coulomb friction. It asks for no other effect and stands for "a build without the effects"; it can sum in plain
/// double, and can stop after each stage, which the product cannot.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "optimized/kernel/node_data.h"
#include "verification/performance/bench/bench_scene.h"
#include "verification/support/timing.h"

namespace type21::bench {

class BareStep {
  public:
    /// Where a step stops. `select`: the retained sub-triangle, kind and side are known. `decide`: the contact point as
    /// well. `look`: like `decide`, and records how the decisions were reached.
    enum class Until { transform, select, decide, look, force, sum };
    enum class Sums { exact, plain };

    /// @param with_friction  damping and friction of the card; otherwise it is elastic
    BareStep(const BenchScene& scene, bool with_friction);

    void step(const Motion& motion, Until until = Until::sum, Sums sums = Sums::exact);

    std::span<const Vec3> force() const { return force_; }
    Vec3 tool_force() const { return tool_force_; }
    const optimized::PathTally& tally() const { return tally_; }

    const optimized::Laws& laws() const { return *laws_; }
    const optimized::Search& search() const { return *laws_->search; }
    /// What the last cycle until `select` or `decide` retained.
    std::vector<Decision> decisions() const;
    /// Where the nodes were in the last cycle until `look`, in the tool frame.
    const std::vector<optimized::V3>& position() const { return position_; }
    const std::vector<optimized::Memory>& memory() const { return nodes_.memory; }
    /// Ranks of the nodes that it had to search for.
    const std::vector<int>& searched() const { return searched_; }
    /// Ranks of the nodes that it decided in an edge neighbour zone.
    const std::vector<int>& edge_neighbour() const { return edge_neighbour_; }
    optimized::ContactReach reach(size_t i) const { return {nodes_.gap[i], laws_->card->depth, 0.0}; }

  private:
    void at_time_zero(const optimized::Cycle& cycle);
    template <bool with_friction, Until until, Sums sums>
    void run(const Motion& motion);
    template <bool with_friction>
    void dispatch(const Motion& motion, Until until, Sums sums);

    bool with_friction_;
    std::unique_ptr<optimized::Laws> laws_;
    optimized::NodeData nodes_;
    std::vector<optimized::V3> position_;
    std::vector<Vec3> force_;
    std::vector<double> step_stiffness_;
    std::vector<int> searched_, edge_neighbour_;
    std::vector<optimized::SubTriangleId> retained_;  ///< of each node
    std::vector<signed char> side_;                   ///< its side
    optimized::PathTally tally_;
    optimized::ExclusiveRegionPolicy exclusive_region_policy_;
    int cycles_ = 0;
    std::unique_ptr<optimized::Workspace> work_;
    Vec3 tool_force_ = Vec3::Zero();
};

/// It, cycle after cycle of its scene.
struct BareRun {
    BareRun(const BenchScene& scene_, bool with_friction, BareStep::Until until_ = BareStep::Until::sum,
            BareStep::Sums sums_ = BareStep::Sums::exact)
        : scene(scene_), until(until_), sums(sums_), bare(scene_, with_friction) {}
    /// Times the next cycle [ns per node].
    double next() {
        const Motion motion = scene.motion(cycle++);
        const Watch watch(true);
        bare.step(motion, until, sums);
        return watch.nanoseconds() / static_cast<double>(scene.nodes());
    }
    /// As ContactRun::settle; the first cycle of a run has a way of its own.
    void settle() {
        for (int c = 0; c < settling_cycles; ++c)
            next();
    }
    const BenchScene& scene;
    BareStep::Until until;
    BareStep::Sums sums;
    BareStep bare;
    int cycle = 0;
};

/// The interface's laws with their search, as the optimized contact makes them.
std::unique_ptr<optimized::Laws> laws_with_search(const Scene& scene, int interface);

}  // namespace type21::bench
