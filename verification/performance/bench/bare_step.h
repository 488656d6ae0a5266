/// @file A step put together by hand, of the product's pieces, for one kind of scene: elastic, or elastic with damping
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
    /// `select` knows who is retained, `decide` where, too; `look` is `decide` and tells how the decisions came about.
    enum class Until { transform, select, decide, look, force, sum };
    enum class Sums { exact, plain };

    /// @param rubbing  damping and friction of the card; otherwise it is elastic
    BareStep(const BenchScene& scene, bool rubbing);

    void step(const Motion& motion, Until until = Until::sum, Sums sums = Sums::exact);

    std::span<const Vec3> force() const { return force_; }
    Vec3 tool_force() const { return tool_force_; }
    const optimized::PathTally& tally() const { return tally_; }

    const optimized::Laws& laws() const { return *laws_; }
    const optimized::Search& search() const { return *laws_->search; }
    /// What the last cycle until `select` or `decide` retained.
    std::vector<Decision> decisions() const;
    /// Where the nodes were in the last cycle until `look`, in the tool frame.
    const std::vector<optimized::V3>& place() const { return place_; }
    const std::vector<optimized::Memory>& memory() const { return nodes_.memory; }
    /// Ranks of the nodes that it had to search for.
    const std::vector<int>& searched() const { return searched_; }
    /// Ranks of those that it decided between two sub-triangles.
    const std::vector<int>& paired() const { return paired_; }
    optimized::ContactReach window(size_t i) const { return {nodes_.gap[i], laws_->card->depth, 0.0}; }

  private:
    void at_time_zero(const optimized::Cycle& cycle);
    template <bool rubbing, Until until, Sums sums>
    void run(const Motion& motion);
    template <bool rubbing>
    void dispatch(const Motion& motion, Until until, Sums sums);

    bool rubbing_;
    std::unique_ptr<optimized::Laws> laws_;
    optimized::NodeData nodes_;
    std::vector<optimized::V3> place_;
    std::vector<Vec3> force_;
    std::vector<double> step_stiffness_;
    std::vector<int> searched_, paired_;
    std::vector<int> retained_;      ///< place of each node, -1: none
    std::vector<signed char> side_;  ///< its side
    optimized::PathTally tally_;
    optimized::ExclusiveRegionPolicy asked_again_;
    int cycles_ = 0;
    std::unique_ptr<optimized::Workspace> work_;
    Vec3 tool_force_ = Vec3::Zero();
};

/// It, cycle after cycle of its scene.
struct BareRun {
    BareRun(const BenchScene& scene_, bool rubbing, BareStep::Until until_ = BareStep::Until::sum,
            BareStep::Sums sums_ = BareStep::Sums::exact)
        : scene(scene_), until(until_), sums(sums_), bare(scene_, rubbing) {}
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
