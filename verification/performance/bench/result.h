/// @file What the bench found; README.md beside this file describes its JSON.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/performance/bench/machine_info.h"
#include "verification/performance/bench/targets.h"
#include "verification/performance/bench/timing.h"

namespace type21::bench {

struct SetUp {
    std::string implementation;
    int threads = 1;
    double seconds = 0;
    size_t bytes = 0;
    double bytes_per_segment = 0;
};

struct SceneRow {
    std::string scene, title, kind;
    size_t segments = 0, sub_triangles = 0, nodes = 0;
    double gap = 0, depth = 0;  ///< [length]
    double step = 0;            ///< way of the tool in a cycle [length]; 0: a deck's own
    double in_contact = 0;      ///< share of the nodes [-]
    int repeats = 0;            ///< rounds of this scene
    std::vector<SetUp> setup;
    size_t bytes_per_node = 0;
    double first_cycle = 0;                             ///< of the coherent step, with all that it finds out once [ns]
    std::vector<std::pair<std::string, double>> paths;  ///< shares of the coherent step [-]
    std::vector<std::pair<std::string, double>> stage_counts;  ///< what settled the decisions of a full search [-]
};

struct MethodRow {
    std::string scene, kind, implementation, method;
    std::string finds;  ///< "impact and forces", "impact", "closest point"
    bool history = false;
    int threads = 1;
    TimingSpread ns;
    long decisions = 0, wrong = 0;
    std::optional<double> ulps_max;  ///< of forces against the reference
    std::string note;
};

struct RatioRow {
    std::string scene, what, slow, fast;
    double of_medians = 0, of_minima = 0;
};

struct StageRow {
    std::string scene, stage;
    double ns = 0, share = 0;
    std::string how;
};

struct EffectRow {
    std::string effect, call;
    double ns_off = 0, ns_on = 0;
    std::optional<double> ns_absent;
};

struct GrowthRow {
    std::string scene;
    size_t segments = 0, nodes = 0;
    double coherent = 0, full_search = 0;  ///< [ns]
    std::optional<double> embree;          ///< [ns]
};

/// A step with one of the searches. Times are [ns] per node and cycle.
struct SearchRow {
    std::string scene, search;       ///< "tree" or "sorted"
    std::optional<double> bumult{};  ///< of the sorted search, like what is below [-]
    double margin = 0;               ///< [length]
    double ns = 0;                   ///< a cycle without a sort, median
    double ns_sort = 0;              ///< one sort, a node
    double cycles_per_sort = 0;
    double ns_in_all = 0;  ///< with the share of the sorts
    double candidates_per_node = 0, boxes_per_node = 0;
    double bytes_per_node = 0, bytes_per_segment = 0;
};

struct ThreadRow {
    std::string scene;
    int threads = 1;
    double ns = 0, speed_up = 1;
    bool same_bits = true;
};

struct Roofline {
    std::string scene;
    double bytes_per_node = 0, flops_per_node = 0;
    double ns_bandwidth = 0, ns_arithmetic = 0, ns_step = 0;
    double limit() const { return std::max(ns_bandwidth, ns_arithmetic); }
};

struct CheckPart {
    std::string what;
    long decisions = 0, different = 0;
    std::string first_difference;
};

struct BenchResult {
    std::string command;
    int repeats = 0;
    bool quick = false;
    double seconds = 0;
    MachineInfo machine;
    std::vector<SceneRow> scenes;
    std::vector<MethodRow> rows;
    std::vector<RatioRow> ratios;
    std::vector<StageRow> stages;
    std::vector<EffectRow> effects;
    std::vector<GrowthRow> growth;
    std::vector<SearchRow> searches;
    std::vector<ThreadRow> threads;
    std::optional<Roofline> roofline;
    std::vector<CheckPart> check;
    std::vector<Target> targets;

    long decisions() const;
    long different() const;
};

/// @throws std::runtime_error naming the place when a number is not finite
nlohmann::ordered_json to_json(const BenchResult& result);
std::string to_text(const BenchResult& result);

}  // namespace type21::bench
