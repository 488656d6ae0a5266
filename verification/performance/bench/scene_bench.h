/// @file One scene with all methods that can answer it: set-up, times in turn, decisions, rows.
#pragma once

#include <algorithm>
#include <memory>

#include "optimized/contact.h"
#include "reference/cycle/contact.h"
#include "verification/criteria/lockstep/step_difference.h"
#include "verification/performance/bench/bare_step.h"
#include "verification/performance/bench/bench.h"
#include "verification/performance/bench/candidate_list.h"
#include "verification/performance/bench/closest_point.h"
#include "verification/performance/bench/contact_run.h"
#include "verification/performance/bench/full_search.h"
#include "verification/performance/bench/plain_search.h"

namespace type21::bench {

/// "implementation, method" of the rows.
namespace method {
inline const std::string coherent = "optimized, coherent step", select = "optimized, coherent selection",
                         project = "optimized, coherent selection and projection",
                         with_report = "optimized, coherent step with the report", full = "optimized, full search",
                         plain = "plain double, full search", reference_step = "reference, step",
                         embree = "Embree, point query with double callback",
                         cgal = "CGAL AABB tree, closest point in double",
                         epick = "CGAL AABB tree, closest point with EPICK", listed = "candidate list, step",
                         listed_search = "candidate list, search and projection";
}  // namespace method

/// Set-up, questions and rows of one scene.
class SceneBench {
  public:
    SceneBench(const BenchScene& scene, const BenchOptions& options, BenchResult& result)
        : scene_(scene),
          options_(options),
          effort_(options.quick),
          result_(result),
          run_(set_up()),
          reference_cycle_(generated() ? 1 : 0),
          beside_(scene.card(), *scene.scene.host, lockstep_) {}

    void add_product();
    void add_competitors();
    void run();
    GrowthRow growth() const;

  private:
    ContactRun set_up();
    template <class Make>
    auto timed_set_up(const std::string& method, const Make& make);
    /// Times one round of a full search over the next part of the nodes: all of them by decide_all(first, count), or
    /// one by one by decide(i).
    template <class Decide>
    double time_part(size_t& start, const Decide& decide_all);
    template <class Decide>
    double time_each(size_t& start, const Decide& decide);
    std::span<const double> gaps() const { return scene_.card().secondary.gap; }
    void add_row(const std::string& name, const std::string& finds, bool history, long decisions, long wrong,
                 const std::string& note = {});
    void add_ratio(const std::string& what, const std::string& slow, const std::string& fast);
    void judge();
    void judge_closest();
    double way_of_reach() const { return 1.05 * std::max(scene_.card().largest_gap, double(scene_.card().depth)); }
    SurfaceMesh mesh() const;
    bool generated() const { return scene_.kind != "deck"; }

    const BenchScene& scene_;
    const BenchOptions& options_;
    Effort effort_;
    BenchResult& result_;
    SceneRow row_;
    ContactRun run_;
    std::unique_ptr<optimized::Laws> laws_;
    std::vector<optimized::V3> position_;
    std::unique_ptr<BareRun> select_, project_;
    std::unique_ptr<FullSearch> full_;
    std::unique_ptr<PlainSearch> plain_;
    std::vector<Decision> found_;
    std::unique_ptr<CandidateList> list_;
    std::unique_ptr<ClosestPoint> embree_, cgal_, epick_;
    std::unique_ptr<reference::Contact> reference_;
    int reference_cycle_;                       ///< where time 0 can be left out it is: nothing moves then
    std::unique_ptr<optimized::Contact> twin_;  ///< steps beside the reference: how far are the forces apart?
    LockstepResult lockstep_;
    StepDifference beside_;
    double sort_ns_ = 0;
    int list_cycle_ = 0;
    size_t at_[5] = {};
    Rounds rounds_;
};

}  // namespace type21::bench
