/// @file Runs a prepared scene into a result folder.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "reference/deck/problem.h"
#include "reference/host/march.h"
#include "reference/model/host_scene.h"
#include "verification/results/record/run_summary.h"

namespace type21 {

struct RunProgress {
    double fraction = 0;  ///< of the end time [-]
    long cycle = 0;
    double time = 0;       ///< [time]
    double time_left = 0;  ///< estimate [s of wall time]
    bool last = false;
};

/// Optional files of a run.
struct RunFiles {
    bool paraview = false;  ///< ParaviewFiles
};

/// Runs a prepared scene into a folder and writes run.json at the end, also when the run stops or something throws.
/// @param progress  called every cycle; may be empty
/// @param with      implementation of the contact, one of contact_choices()
/// @throws FolderError before anything is computed when the folder cannot be used
RunSummary run_scene(const HostScene& scene, const Problems& problems, const std::filesystem::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options = {},
                     const std::string& with = "reference", const RunFiles& files = {});

/// The same with any contact.
RunSummary run_scene(const HostScene& scene, const Problems& problems, const std::filesystem::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options,
                     const MakeContact& make, const RunFiles& files = {});

}  // namespace type21
