/// @file Accuracy against time: all methods on all scenes, in one process, timed in turn.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verification/performance/accuracy/effect_cost.h"
#include "verification/performance/accuracy/score.h"
#include "verification/performance/accuracy/timing.h"

namespace type21::accuracy {

struct Options {
    bool quick = false;
    int repeats = 0;  ///< of each time; 0: 21 when quick, 41 otherwise
    std::uint64_t seed = 1;
    std::vector<std::string> scenes;  ///< names; none: all, and the effects
    std::function<void(const std::string&)> progress;

    int repeats_of_all() const { return repeats > 0 ? repeats : quick ? 21 : 41; }
    /// Decisions of a scene.
    size_t decisions() const { return quick ? 1344 : 20160; }
    /// Processor time that one method may take on one scene to be compared with the exact answers [s].
    double comparing_seconds() const { return quick ? 0.1 : 1.0; }
    /// Processor time of one repeat of one method, about [s].
    double pass_seconds() const { return quick ? 0.0025 : 0.015; }
};

struct SceneRow {
    std::string name, kind, what;
    size_t decisions = 0, contact = 0, proximity = 0, none = 0;  ///< queries, and their exact kinds
    size_t forced = 0;                                           ///< with an exact force to compare with
    size_t segments = 0;                                         ///< of all its tools
    double candidates = 0;                                       ///< segments that may reach a node, mean
};

struct MethodRow {
    std::string scene, kind, group, method, implementation, what;
    bool exact = false;
    Score score;
    TimingSpread ns;   ///< for one decision, over the repeats
    size_t timed = 0;  ///< decisions in each repeat
};

struct StageRow {
    std::string name;
    size_t settled = 0;
    TimingSpread ns;  ///< for one decision that ended in this stage, all stages before it included
    size_t timed = 0;
};

/// Which stage settled the decisions of a scene.
struct StageCountsRow {
    std::string scene, kind, implementation;
    std::vector<StageRow> stages;
};

struct Result {
    Options options;
    std::vector<SceneRow> scenes;
    std::vector<MethodRow> rows;
    std::vector<StageCountsRow> stage_counts;
    std::vector<EffectCost> effects;
    double seconds = 0;  ///< of wall time

    /// True when no method that promises exact decisions was wrong.
    bool exact_ones_are_right() const;
};

Result measure(const Options& options);

}  // namespace type21::accuracy
