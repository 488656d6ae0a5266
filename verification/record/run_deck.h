/// @file The whole chain from a deck to a result folder: read, resolve, plan, march, record.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "reference/deck/problem.h"
#include "reference/host/march.h"
#include "reference/model/scene.h"
#include "verification/record/run_summary.h"

namespace type21 {

/// A scene, or the problems that there is none for. Warnings are in problems either way.
struct PreparedDeck {
    Problems problems;
    std::optional<Scene> scene;
    std::optional<ThicknessHistory> thickness;  ///< of --thickness

    /// For run_scene; points into this.
    MarchOptions options() const { return {thickness ? &*thickness : nullptr}; }
};

/// @param needs_engine  true when the scene is to be run: a missing engine deck is then an error
/// @param thickness     CSV of the shells' thickness over time, empty: none
PreparedDeck prepare_deck(const std::string& path, const std::string& as_built, bool needs_engine,
                          const std::string& thickness = {});

struct RunProgress {
    double fraction = 0;  ///< of the end time [-]
    long cycle = 0;
    double time = 0;       ///< [time]
    double time_left = 0;  ///< estimate [s of wall time]
    bool last = false;
};

/// What a run leaves beside its histories.
struct RunFiles {
    bool paraview = false;  ///< ParaviewFiles
};

/// Runs a prepared scene into a folder and writes run.json at the end, also when the run stops or something throws.
/// @param progress  called every cycle; may be empty
/// @param with      who computes the contact, one of contact_choices()
/// @throws FolderError before anything is computed when the folder cannot be used
RunSummary run_scene(const Scene& scene, const Problems& problems, const std::filesystem::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options = {},
                     const std::string& with = "reference", const RunFiles& files = {});

/// The same with any contact.
RunSummary run_scene(const Scene& scene, const Problems& problems, const std::filesystem::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options,
                     const MakeContact& make, const RunFiles& files = {});

}  // namespace type21
