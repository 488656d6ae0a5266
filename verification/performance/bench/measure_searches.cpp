// The step with the tree, and with the sorted search at several values of Bumult.
#include <algorithm>
#include <memory>
#include <tbb/task_arena.h>

#include <fmt/format.h>

#include "optimized/search/segment_boxes.h"
#include "optimized/search/sorted/candidate_lists.h"
#include "verification/performance/bench/bare_step.h"
#include "verification/performance/bench/bench.h"
#include "verification/performance/bench/contact_run.h"

namespace type21::bench {

namespace {

using optimized::SearchKind;

/// The defaults of the card by the size of the model are 0.2, 0.3 and 0.4.
std::vector<double> sorting_factors(bool quick) {
    if (quick) return {0.05, 0.2, 0.3, 0.4, 1};
    return {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 1, 2};
}

std::string method_of(double bumult) {
    return fmt::format("Bumult {:g}", bumult);
}

/// Places of the nodes of a cycle in the tool frame.
std::vector<optimized::V3> places(const BenchScene& scene, int cycle) {
    const Motion motion = scene.motion(cycle);
    const ToolMotion& tool = motion.tools[static_cast<size_t>(scene.card().tool)];
    std::vector<optimized::V3> y;
    for (const int node : scene.card().secondary.node)
        y.push_back(
            optimized::from(tool.rotation.transpose() * (motion.position[static_cast<size_t>(node)] - tool.position)));
    return y;
}

/// How many cycles lists last where the tool moves on evenly.
double cycles_per_sort(const BenchScene& scene, double margin) {
    const Vec3 way = scene.motion(1).tools[0].position - scene.motion(0).tools[0].position;
    return std::floor(margin / way.cwiseAbs().maxCoeff()) + 1;
}

/// One sort of all nodes, median of a few [ns per node].
double sort_time(const BenchScene& scene, const std::vector<optimized::Box>& boxes, double margin, int repeats) {
    const std::vector<optimized::V3> y = places(scene, 0);
    optimized::CandidateLists lists(boxes, margin);
    std::vector<double> times;
    for (int r = 0; r < repeats; ++r) {
        std::vector<optimized::V3> copy = y;
        const Watch watch(true);
        lists.sort(std::move(copy));
        times.push_back(watch.nanoseconds() / static_cast<double>(scene.nodes()));
    }
    return timing_spread(times).p50;
}

}  // namespace

void measure_searches(const BenchScene& scene, const BenchOptions& options, BenchResult& result) {
    const Effort effort(options.quick);
    const std::vector<double> factors = sorting_factors(options.quick);
    tbb::task_arena arena(1);
    arena.execute([&] {
        const auto laws = laws_with_search(scene.scene, scene.interface);
        const std::vector<optimized::Box> boxes = optimized::segment_boxes(laws->tool, laws->search->limits());
        std::vector<std::unique_ptr<ContactRun>> runs;
        Rounds rounds;
        const auto add = [&](const std::string& name, const optimized::ContactOptions& how) {
            runs.push_back(std::make_unique<ContactRun>(scene, how));
            runs.back()->settle();
            rounds.add(
                name, [run = runs.back().get()] { return run->next(true); },
                scene.cycles > 0 ? scene.cycles : effort.cycles);
        };
        add("tree", {});
        for (const double bumult : factors)
            add(method_of(bumult), {SearchKind::sorted, bumult});
        rounds.run(scene.cycles > 0 ? 1 : effort.repeats, effort.seconds);
        SearchRow tree{scene.name, "tree"};
        tree.ns = tree.ns_in_all = rounds.of("tree").p50;
        tree.bytes_per_node = static_cast<double>(runs[0]->contact().bytes_per_node());
        tree.bytes_per_segment =
            static_cast<double>(runs[0]->contact().tool_bytes()) / static_cast<double>(scene.segments().size());
        result.searches.push_back(tree);
        for (size_t i = 0; i < factors.size(); ++i) {
            optimized::Contact& contact = runs[i + 1]->contact();
            const optimized::SortedSearchCounts counts = *contact.sorted_search();
            SearchRow row{scene.name, "sorted"};
            row.bumult = factors[i];
            row.margin = counts.margin;
            row.ns = rounds.of(method_of(factors[i])).p50;
            row.ns_sort = sort_time(scene, boxes, counts.margin, 3);
            row.cycles_per_sort =
                scene.cycles > 0 ? static_cast<double>(counts.cycles) / static_cast<double>(std::max(counts.sorts, 1L))
                                 : cycles_per_sort(scene, counts.margin);
            row.ns_in_all = row.ns + row.ns_sort / row.cycles_per_sort;
            row.candidates_per_node = counts.candidates_per_node();
            row.boxes_per_node = counts.near_per_node();
            row.bytes_per_node = static_cast<double>(contact.bytes_per_node());
            row.bytes_per_segment =
                static_cast<double>(contact.tool_bytes()) / static_cast<double>(scene.segments().size());
            result.searches.push_back(row);
            if (factors[i] == 0.2)
                result.ratios.push_back({scene.name, "step with the sorted search, Bumult 0.2 / step with the tree",
                                         method_of(0.2), "tree", rounds.of_medians(method_of(0.2), "tree"),
                                         rounds.of_minima(method_of(0.2), "tree")});
        }
    });
}

}  // namespace type21::bench
