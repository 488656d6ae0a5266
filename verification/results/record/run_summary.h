/// @file run.json: the model, the program and the outcome of a run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "optimized/contact.h"
#include "reference/host/march.h"
#include "reference/host/saved_state.h"
#include "verification/results/balance/balance.h"
#include "verification/results/balance/contact_count.h"

namespace type21 {

/// The run that this one goes on with.
struct RestartedFrom {
    std::string run_id;
    long cycle = 0;   ///< n of the first cycle that this run computed
    double time = 0;  ///< its t_n [time]
};

struct RunSummary {
    enum class State { running, completed, stopped, diverged, interrupted };
    State state = State::running;
    std::string run_id;
    std::optional<RestartedFrom> restarted_from;
    std::string reason;        ///< why it stopped, empty otherwise
    long cycles = 0;           ///< number of cycles observed
    double time = 0;           ///< t_n of the last cycle [time]
    double smallest_step = 0;  ///< dt2 over the cycles [time]
    double largest_step = 0;   ///< [time]
    double wall_seconds = 0;
    std::vector<std::string> warnings;    ///< of the run itself, beside those of its deck
    std::vector<InterfaceTotals> totals;  ///< of the last cycle, per interface
    std::vector<InterfaceBalance> balance;
    std::vector<ContactCount> contact;
    std::vector<std::vector<EffectMemory>> memory;  ///< bytes that each effect of an interface takes per node
    std::vector<DecisionStageCounts> stage_counts;  ///< how many decisions of each interface each stage settled

    /// Of the optimized contact with the sorted search; empty otherwise.
    std::vector<std::optional<optimized::SortedSearchCounts>> sorted_search;
    std::string checkpoint;          ///< the last one written, where it is now; empty: none
    std::vector<std::string> notes;  ///< what the run found beside its folder

    void observe(const CycleRecord& record);
    /// What a restart takes over. A run that goes on may stop in its first cycle, so it is all that a cycle sets.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(cycles, time, smallest_step, largest_step, wall_seconds);
        // Lists that a new object does not have yet: their sizes come first.
        const auto list = [&archive](auto& entries) {
            size_t count = entries.size();
            archive(count);
            entries.resize(count);
        };
        list(warnings);
        list(totals);
        list(stage_counts);
        list(sorted_search);  // its counts come with the next cycle
        list(memory);
        for (std::vector<EffectMemory>& of_interface : memory) {
            list(of_interface);
            for (auto& [effect, bytes_per_node, report_bytes_per_node] : of_interface)
                archive(effect, bytes_per_node, report_bytes_per_node);
        }
        archive(warnings, totals, stage_counts);
    }
};

/// "running", "completed", "stopped", "diverged" or "interrupted".
std::string_view name(RunSummary::State state);

/// @param warnings  those of the deck, as text
nlohmann::ordered_json to_json(const RunSummary& summary, const HostScene& scene,
                               const std::vector<std::string>& warnings);

/// The resolved model alone: units, parameters, surfaces, effects. Shared with `type21 check --json`.
nlohmann::ordered_json model_json(const HostScene& scene);

/// Replaces run.json in one step, so that a reader never sees an incomplete file.
/// @throws IoError
void write_json(const std::filesystem::path& path, const nlohmann::ordered_json& json);

}  // namespace type21
