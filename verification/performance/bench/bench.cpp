#include "verification/performance/bench/bench.h"

#include <algorithm>
#include <stdexcept>
#include <tbb/global_control.h>

#include <fmt/format.h>

#include "verification/performance/bench/closest_point.h"
#include "verification/support/contact_choice.h"

namespace type21::bench {

namespace {

double ratio_of(const BenchResult& result, const std::string& scene, const std::string& what) {
    for (const RatioRow& row : result.ratios)
        if (row.scene == scene && row.what == what) return row.of_medians;
    throw std::logic_error("bench: no ratio '" + what + "' of scene " + scene);
}

constexpr const char* exactness = "full search / the same in plain double (cost of exactness)";

void add_embree_targets(const BenchScene& scene, const std::string& number, int size, BenchResult& result) {
    const double least = size >= 500000 ? 5 : 10, aim = size >= 500000 ? 10 : (size >= 100000 ? 15 : 20);
    result.targets.push_back(
        {"coherent selection against Embree's full search, " + number, scene.name, "x", Better::higher, least, aim,
         ratio_of(result, scene.name, "Embree's full search / coherent selection"),
         fmt::format("with projection {:.2f} x, with forces {:.2f} x",
                     ratio_of(result, scene.name, "Embree's full search / coherent selection and projection"),
                     ratio_of(result, scene.name, "Embree's full search / coherent step"))});
    result.targets.push_back({"full search against Embree's, " + number, scene.name, "x", Better::higher, 1.0, 1.5,
                              ratio_of(result, scene.name, "Embree's full search / full search"), ""});
}

/// Targets that are ratios of methods of one scene.
void add_pan_targets(const BenchScene& scene, int size, BenchResult& result) {
    const auto number = short_count(size);
    if (has_embree()) add_embree_targets(scene, number, size, result);
    result.targets.push_back({"cost of exactness, ordinary scene, " + number, scene.name, "x", Better::lower, 1.1, 1.02,
                              ratio_of(result, scene.name, exactness), "full search"});
    const SceneRow& row = result.scenes.back();
    for (const SetUp& one : row.setup) {
        if (size < 1000000 || one.implementation != "optimized") continue;
        result.targets.push_back(
            {fmt::format("set-up of {} segments, {} {}", number, one.threads, one.threads == 1 ? "thread" : "threads"),
             scene.name, "s", Better::lower, 0.5, 0.2, one.seconds, ""});
    }
    result.targets.push_back({"memory of a segment, " + number, scene.name, "B", Better::lower, 200, 200,
                              row.setup.front().bytes_per_segment, ""});
}

/// How the decisions to compare are shared out: an exact answer of the adversarial families costs a hundred times one
/// of the scenes, and `fuzz` asks them without end.
struct CheckShares {
    explicit CheckShares(long all) : bowl(all / 10), ties(all / 20), families(std::min(all / 20, 500000L)) {
        pans = all - bowl - bowl / 2 - ties - families;
    }
    long bowl, ties, families, pans;
};

void time_bowl(const BenchOptions& options, BenchResult& result) {
    const BenchScene bowl = bowl_bench(options.blank, options.tool);
    options.progress(fmt::format("bowl: {} nodes on {} quads", bowl.nodes(), bowl.segments().size()));
    measure_methods(bowl, options, true, result);
    result.targets.push_back({"step of the bowl against a candidate list", bowl.name, "x", Better::higher, 8, 20,
                              ratio_of(result, bowl.name, "candidate list / coherent step"), ""});
    result.targets.push_back({"cost of exactness, bowl", bowl.name, "x", Better::lower, 1.1, 1.02,
                              ratio_of(result, bowl.name, exactness), "full search; both meshes are structured"});
    options.progress("bowl: stages, sums");
    measure_stages(bowl, options, result);
    options.progress("bowl: searches");
    measure_searches(bowl, options, result);
    options.progress("bowl: threads");
    measure_threads(bowl, options, result);
    options.progress("bowl: effects on and off");
    measure_effects(options, result);
    if (options.check == 0) return;
    options.progress("bowl: check of decisions");
    result.check.push_back(check_steps(bowl, CheckShares(options.check).bowl));
    result.check.push_back(
        check_steps(bowl, CheckShares(options.check).bowl / 2, contact_maker("optimized", "sorted")));
    result.check.back().what += ", with the sorted search";
}

void time_ties(const BenchOptions& options, BenchResult& result) {
    const BenchScene ties = ties_bench(options.quick ? options.ties / 2 : options.ties);
    options.progress(fmt::format("ties: {} nodes on {} quads", ties.nodes(), ties.segments().size()));
    measure_methods(ties, options, true, result);
    result.targets.push_back({"cost of exactness, structured ties", ties.name, "x", Better::lower, 2, 1.3,
                              ratio_of(result, ties.name, exactness), "full search"});
    if (options.check > 0) result.check.push_back(check_steps(ties, CheckShares(options.check).ties));
}

void time_pan(int size, const BenchOptions& options, BenchResult& result) {
    const std::string name = "pan_" + short_count(size);
    const BenchScene pan = pan_bench(name, size, options.usual_nodes);
    options.progress(fmt::format("{}: {} nodes", name, pan.nodes()));
    result.growth.push_back(measure_methods(pan, options, true, result).value());
    add_pan_targets(pan, size, result);
    options.progress(name + ": searches");
    measure_searches(pan, options, result);
    if (options.check > 0) {
        options.progress(name + ": check of decisions");
        const auto pans = static_cast<long>(options.sizes.size());
        const long share = (CheckShares(options.check).pans + pans - 1) / pans;
        result.check.push_back(check_steps(pan, share));
    }
    options.progress(name + ": gap 0.5 mm");
    const BenchScene sheet = pan_bench(name + "_sheet", size, options.usual_nodes, 0.5);
    measure_methods(sheet, options, false, result);
    for (const int nodes : options.nodes) {
        if (nodes == options.usual_nodes) continue;
        options.progress(fmt::format("{}: {} nodes", name, short_count(nodes)));
        const BenchScene other = pan_bench(fmt::format("{}_{}_nodes", name, short_count(nodes)), size, nodes);
        result.growth.push_back(measure_methods(other, options, false, result).value());
    }
}

void time_generated(const BenchOptions& options, BenchResult& result) {
    time_bowl(options, result);
    time_ties(options, result);
    for (const int size : options.sizes)
        time_pan(size, options, result);
    if (options.check == 0) return;
    options.progress("adversarial families: check of decisions");
    result.check.push_back(check_families(CheckShares(options.check).families, options.threads.back()));
}

void add_growth_target(int usual_nodes, BenchResult& result) {
    const GrowthRow *small = nullptr, *large = nullptr;
    for (const GrowthRow& row : result.growth) {
        if (row.nodes != static_cast<size_t>(usual_nodes)) continue;
        if (small == nullptr || row.segments < small->segments) small = &row;
        if (large == nullptr || row.segments > large->segments) large = &row;
    }
    if (small == nullptr || small == large || small->segments > 30000 || large->segments < 900000) return;
    result.targets.push_back({"growth of the coherent step from 20k to 1M", large->scene, "x", Better::lower, 3, 1.5,
                              large->coherent / small->coherent, ""});
}

}  // namespace

BenchResult run_bench(const BenchOptions& options) {
    const Watch watch(false);
    const int most = *std::max_element(options.threads.begin(), options.threads.end());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(most));
    BenchResult result;
    result.quick = options.quick;
    result.repeats = Effort(options.quick).repeats;
    if (!has_embree()) options.progress("built without Embree: CGAL and the candidate list are compared with");
    options.progress("bandwidth and arithmetic of the machine");
    result.machine = measure_machine(options.threads, options.quick ? 64 : 256, options.quick ? 3 : 10);
    if (!options.sizes.empty()) time_generated(options, result);
    if (options.deck) {
        for (size_t i = 0; i < options.deck->model->interfaces.size(); ++i) {
            const BenchScene deck = deck_bench(*options.deck, static_cast<int>(i), options.deck_cycles);
            options.progress(fmt::format("{}: {} nodes, {} cycles", deck.name, deck.nodes(), deck.cycles));
            measure_methods(deck, options, true, result);
            measure_searches(deck, options, result);
            if (options.check > 0) result.check.push_back(check_deck(deck, options.check));
        }
    }
    add_growth_target(options.usual_nodes, result);
    result.seconds = watch.seconds();
    return result;
}

}  // namespace type21::bench
