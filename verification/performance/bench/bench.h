/// @file The bench: what to measure, and all of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reference/host/march.h"
#include "verification/performance/bench/bench_scene.h"
#include "verification/performance/bench/result.h"

namespace type21::bench {

struct BenchOptions {
    std::vector<int> sizes;                          ///< triangles of the pan; empty: no generated scenes
    std::vector<int> nodes{10000, 100000, 1000000};  ///< of the pan, beside the usual number
    bool quick = false;
    std::vector<int> threads{1, 2};
    long check = 200000;            ///< decisions to compare with exact ones; 0: none
    std::optional<HostScene> deck;  ///< each of its interfaces is timed
    int deck_cycles = 200;          ///< of the deck, at most
    // Smaller ones are for tests.
    int blank = 316, tool = 220;  ///< quads of the bowl, a side
    int ties = 120;               ///< quads of the tool of the ties, a side; half of it when quick
    int usual_nodes = 100000;     ///< of the pan
    std::function<void(const std::string&)> progress = [](const std::string&) {};
};

BenchResult run_bench(const BenchOptions& options);

// What run_bench is made of. One thread unless said otherwise.

/// How long and how often.
struct Effort {
    int repeats = 21;
    int cycles = 5;         ///< coherent cycles a round
    int questions = 50000;  ///< of a full search a round
    double seconds = 20;    ///< of a scene, about
    explicit Effort(bool quick) {
        if (!quick) return;
        repeats = 5;
        cycles = 2;
        questions = 10000;
        seconds = 1.5;
    }
};

/// Rows, ratios, set-up, paths of one scene.
/// @param competitors  false: the optimized contact alone
/// @return the row for the growth, of a generated scene
std::optional<GrowthRow> measure_methods(const BenchScene& scene, const BenchOptions& options, bool competitors,
                                         BenchResult& result);
/// Stages, cost of the sums, roofline. For a generated scene.
void measure_stages(const BenchScene& scene, const BenchOptions& options, BenchResult& result);
/// Cost of the two searches, that of the sorted one against Bumult.
void measure_searches(const BenchScene& scene, const BenchOptions& options, BenchResult& result);
void measure_effects(const BenchOptions& options, BenchResult& result);
void measure_threads(const BenchScene& scene, const BenchOptions& options, BenchResult& result);

/// Decisions of a step in `count` node cycles, with its history, leaps and turns, against exact ones.
/// @param make  whose step; empty: the optimized contact's
CheckPart check_steps(const BenchScene& scene, long count, const MakeContact& make = {});
/// The recorded cycles of a deck, both implementations side by side.
CheckPart check_deck(const BenchScene& scene, long count);
/// Questions of the adversarial families, each answered by optimized::decide_query and by an independent evaluation.
CheckPart check_families(long count, int threads);

}  // namespace type21::bench
