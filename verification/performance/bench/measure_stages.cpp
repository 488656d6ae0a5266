#include <algorithm>
#include <array>
#include <memory>
#include <tbb/task_arena.h>

#include "optimized/projection/project_double.h"
#include "verification/performance/bench/bare_step.h"
#include "verification/performance/bench/bench.h"
#include "verification/performance/bench/contact_run.h"

namespace type21::bench {

namespace {

using optimized::ProjectionBatch;

/// The projections of `count` nodes on their last sub-triangles, as if all lay in the exclusive region.
std::vector<ProjectionBatch> projections(const BareStep& bare, size_t count) {
    std::vector<ProjectionBatch> blocks(std::max<size_t>(count / ProjectionBatch::capacity, 1));
    const optimized::CaptureLimits& limits = bare.search().limits();
    size_t i = 0;
    for (ProjectionBatch& rows : blocks) {
        std::array<optimized::SubTriangleId, ProjectionBatch::capacity> id;
        for (size_t column = 0; column < id.size(); ++column, ++i) {
            const size_t n = std::min(i, bare.position().size() - 1);
            const optimized::SubTriangleId last = bare.memory()[n].last;
            id[column] = last.exists() ? last : optimized::SubTriangleId(0, 1);
            for (int a = 0; a < 3; ++a)
                rows.y[a][column] = bare.position()[n][a];
            rows.exclusive_margin[column] = 0;
            rows.gap[column] = bare.reach(n).gap;
        }
        gather(rows, bare.laws().tool, id.data(), 0, ProjectionBatch::capacity,
               std::max(limits.outward, limits.inward));
    }
    return blocks;
}

/// Decides nodes once more, batch by batch: from their last sub-triangles, or by a full search.
class RepeatedDecision {
  public:
    enum class How { from_last, full_search };
    RepeatedDecision(const BareStep& bare, const std::vector<int>& nodes, How how)
        : bare_(bare), nodes_(nodes), how_(how) {}
    void operator()() {
        for (size_t first = 0; first < nodes_.size(); first += optimized::Search::Batch::capacity) {
            const size_t count = std::min<size_t>(optimized::Search::Batch::capacity, nodes_.size() - first);
            batch_->count = static_cast<int>(count);
            batch_->memory = memory_.data();
            std::fill_n(batch_->active, count, true);
            batch_->depth = bare_.reach(0).depth;
            batch_->proximity = 0;
            for (size_t j = 0; j < count; ++j) {
                const auto i = static_cast<size_t>(nodes_[first + j]);
                for (int a = 0; a < 3; ++a)
                    batch_->y[a][j] = bare_.position()[i][a];
                batch_->gap[j] = bare_.reach(i).gap;
                memory_[j] = bare_.memory()[i];
                memory_[j].forget();
            }
            if (how_ == How::from_last)
                bare_.search().find(*batch_, bare_.laws().rules);
            else
                bare_.search().search(*batch_, bare_.laws().rules);
            keep(*batch_);
        }
    }

  private:
    const BareStep& bare_;
    const std::vector<int>& nodes_;
    How how_;
    std::unique_ptr<optimized::Search::Batch> batch_ = std::make_unique<optimized::Search::Batch>();
    std::array<optimized::Memory, optimized::Search::Batch::capacity> memory_;
};

/// Bytes of a node that one step must read or write: what streams through, not the tool, which nodes share.
double streamed_bytes() {
    constexpr double position = 24, velocity = 24, constants = 3 * 8 + 4;  // gap, stiffness, mass; rank
    constexpr double history = 2 * (8 + 4 + 24);                           // offset, count, friction: read and written
    constexpr double out = 2 * (24 + 8);  // force, stiffness: a line is fetched before it is written
    return position + velocity + constants + history + 2 * sizeof(optimized::Memory) + out;
}

/// Additions, multiplications, divisions and roots of one node, counted in the text of the optimized step: transform
/// 18, projection with its certificate 330, contact point 60, forces 90, terms of the sums 60, their exact sum 27
/// times 8, four for each of two slices.
constexpr double flops = 18 + 330 + 60 + 90 + 60 + 27 * 8;

}  // namespace

void measure_stages(const BenchScene& scene, const BenchOptions& options, BenchResult& result) {
    using Until = BareStep::Until;
    using Sums = BareStep::Sums;
    const Effort effort(options.quick);
    tbb::task_arena one(1);
    one.execute([&] {
        BareRun transform(scene, true, Until::transform), decide(scene, true, Until::decide),
            force(scene, true, Until::force), sum(scene, true), plain(scene, true, Until::sum, Sums::plain);
        ContactRun product(scene);
        Rounds rounds;
        BareRun look(scene, true, Until::look);
        for (BareRun* run : {&transform, &decide, &force, &sum, &plain, &look})
            run->settle();
        product.settle();
        // As in the step, the rows stay near: few of them, again and again.
        std::vector<ProjectionBatch> rows = projections(look.bare, std::min<size_t>(scene.nodes(), 256));
        const optimized::CaptureLimits& reach = look.bare.search().limits();
        const optimized::BatchLimits limits{reach.outward, reach.inward, look.bare.reach(0).depth, 0, true};
        RepeatedDecision neighbours(look.bare, look.bare.edge_neighbour(), RepeatedDecision::How::from_last);
        RepeatedDecision searched(look.bare, look.bare.searched(), RepeatedDecision::How::full_search);
        const double nodes = static_cast<double>(scene.nodes());
        rounds.add(
            "product", [&] { return product.next(true); }, effort.cycles);
        rounds.add(
            "transform", [&] { return transform.next(); }, effort.cycles);
        rounds.add(
            "decide", [&] { return decide.next(); }, effort.cycles);
        rounds.add(
            "force", [&] { return force.next(); }, effort.cycles);
        rounds.add(
            "sum", [&] { return sum.next(); }, effort.cycles);
        rounds.add(
            "plain sums", [&] { return plain.next(); }, effort.cycles);
        rounds.add("project", [&] {
            constexpr int times = 64;
            const Watch watch(true);
            for (int t = 0; t < times; ++t) {
                for (ProjectionBatch& block : rows)
                    project_double(block, 0, ProjectionBatch::capacity, limits);
                keep(rows);
            }
            return watch.nanoseconds() / static_cast<double>(times * rows.size() * ProjectionBatch::capacity);
        });
        rounds.add("neighbours", [&] {
            const Watch watch(true);
            neighbours();
            return watch.nanoseconds() / nodes;
        });
        rounds.add("search", [&] {
            const Watch watch(true);
            searched();
            return watch.nanoseconds() / nodes;
        });
        rounds.run(effort.repeats, effort.seconds);
        const auto median = [&](const char* name) { return rounds.of(name).p50; };
        const double step = median("sum"), deciding = median("decide") - median("transform");
        const double searching = median("search"), projecting = median("project"), pairing = median("neighbours");
        const auto add = [&](const char* stage, double ns, const char* how) {
            result.stages.push_back({scene.name, stage, ns, ns / step, how});
        };
        add("transform", median("transform"), "a step that stops there");
        add("certify", deciding - searching - pairing - projecting, "deciding, less the next three");
        add("neighbours", pairing, "the nodes in edge neighbour zones decided once more");
        add("search", searching, "the nodes without a certificate searched for once more");
        add("project", projecting, "the projections of the step alone");
        add("force", median("force") - median("decide"), "difference of two steps that stop early");
        add("sum", step - median("force"), "the full step less one that stops there");
        result.ratios.push_back({scene.name, "reproducible sums / plain sums, full step", "step by hand",
                                 "step by hand, plain sums", rounds.of_medians("sum", "plain sums"),
                                 rounds.of_minima("sum", "plain sums")});
        result.targets.push_back({"reproducible sums against plain sums, full step", scene.name, "x", Better::lower,
                                  1.05, 1.01, rounds.of_medians("sum", "plain sums"), ""});
        const Bandwidth& memory = result.machine.bandwidth.front();
        Roofline roofline{scene.name, streamed_bytes(), flops, 0, 0, median("product")};
        roofline.ns_bandwidth = roofline.bytes_per_node / std::max(memory.copy, memory.triad);
        roofline.ns_arithmetic = roofline.flops_per_node / result.machine.fma;
        result.roofline = roofline;
        result.targets.push_back({"step over max(bytes/bandwidth, flops/peak)", scene.name, "x", Better::lower, 3, 2,
                                  roofline.ns_step / roofline.limit(), ""});
        result.targets.push_back({"step of the bowl, ns per node and cycle", scene.name, "ns", Better::lower, 100, 40,
                                  median("product"), "1040 ns in OpenRadioss on another machine"});
    });
}

void measure_threads(const BenchScene& scene, const BenchOptions& options, BenchResult& result) {
    const Effort effort(options.quick);
    std::vector<std::unique_ptr<ContactRun>> runs;
    std::vector<std::unique_ptr<tbb::task_arena>> arenas;
    Rounds rounds;
    for (const int threads : options.threads) {
        arenas.push_back(std::make_unique<tbb::task_arena>(threads));
        runs.push_back(std::make_unique<ContactRun>(scene));
        runs.back()->settle();
        rounds.add(
            std::to_string(threads),
            [run = runs.back().get(), arena = arenas.back().get()] {
                return arena->execute([&] { return run->next(true, false); });
            },
            2 * effort.cycles);
    }
    rounds.run(effort.repeats, effort.seconds);
    std::vector<Vec3> first;
    for (size_t i = 0; i < options.threads.size(); ++i) {
        const Motion motion = scene.motion(runs[i]->cycle());
        const ContactStep step = arenas[i]->execute([&] { return runs[i]->contact().step(motion); });
        std::vector<Vec3> force{step.tool.force, step.tool.moment};
        for (const NodeContact& node : step.nodes)
            force.push_back(node.force);
        if (i == 0) first = force;
        const double ns = rounds.of(std::to_string(options.threads[i])).p50;
        const double speed_up =
            rounds.of_medians(std::to_string(options.threads[0]), std::to_string(options.threads[i]));
        result.threads.push_back({scene.name, options.threads[i], ns, speed_up, force == first});
        if (options.threads[0] == 1 && options.threads[i] == 2)
            result.targets.push_back({"two threads against one", scene.name, "x", Better::higher, 1.8, 1.95, speed_up,
                                      "needs two idle processors"});
    }
}

}  // namespace type21::bench
