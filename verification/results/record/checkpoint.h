/// @file A checkpoint: the state of a run between two cycles, from which the run can go on.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/results/tables/csv_writer.h"

namespace type21 {

/// The file is no checkpoint, is damaged, or is of another run; the message has file and reasons. Exit code 2.
struct CheckpointError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What must be the same when a run goes on, or its results would not be those of one run.
struct RunIdentity {
    std::string program;   ///< version, commit, compiler and flags
    std::string inputs;    ///< checksum of the deck's files and of the thickness
    std::string as_built;  ///< departures: "none", "D24, D25"
    std::string with;      ///< implementation of the contact
    bool paraview = false;
};

/// @param files  that were read
/// @throws IoError
RunIdentity identity_of(const std::vector<std::string>& files, const std::string& as_built, const std::string& with,
                        bool paraview);

/// The histories are not in the checkpoint: it says how much of the files beside it belongs to it.
struct Checkpoint {
    std::string run_id;  ///< of the run that wrote it
    long cycle = 0;      ///< n of the cycle that follows
    double time = 0;     ///< its t_n [time]
    RunIdentity identity;
    std::vector<WrittenFile> files;      ///< CSVs
    std::vector<double> paraview_times;  ///< of the files for ParaView [time]
    std::string state;                   ///< @see StateWriter
};

/// In one step: a reader meets the checkpoint before or this one. @throws IoError
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);
/// @throws CheckpointError
Checkpoint read_checkpoint(const std::filesystem::path& path);
/// @throws CheckpointError with every difference, unless both are the same
void require_same(const std::filesystem::path& path, const RunIdentity& then, const RunIdentity& now);
/// Copies the CSVs as they were at the checkpoint, from the folder that it lies in.
/// @throws CheckpointError when a file is shorter now or has changed, IoError
void copy_histories(const std::filesystem::path& path, const Checkpoint& checkpoint, const std::filesystem::path& into);

}  // namespace type21
