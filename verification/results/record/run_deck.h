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

/// What a run writes beside its histories, and how it may end and go on.
struct RunFiles {
    bool paraview = false;            ///< ParaviewFiles
    long checkpoint_every = 0;        ///< cycles; 0: no checkpoint
    bool keep_checkpoints = false;    ///< each under a name of its own, not only the last
    std::filesystem::path restart{};  ///< checkpoint to go on from; empty: from time 0
    /// The files that the deck was read from: a restart asks whether they are as they were.
    std::vector<std::string> inputs{};
    std::string with{};                   ///< what the contact is called: a restart asks for the same
    std::function<bool()> interrupted{};  ///< asked between two cycles: true ends the run there
    bool durable = false;                 ///< ResultFolder::publish
};

/// Runs a prepared scene into a folder of its own, which takes the place of `folder` at the end, also when the run
/// stops or is interrupted: run.json says how it ended. When it cannot be written, `folder` stays as it was.
/// @param progress  called every cycle; may be empty
/// @param with      implementation of the contact, one of contact_choices()
/// @throws FolderError and CheckpointError before anything is computed; IoError
RunSummary run_scene(const HostScene& scene, const Problems& problems, const std::filesystem::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options = {},
                     const std::string& with = "reference", RunFiles files = {});

/// The same with any contact; files.with names it.
RunSummary run_scene(const HostScene& scene, const Problems& problems, const std::filesystem::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options,
                     const MakeContact& make, const RunFiles& files = {});

}  // namespace type21
