/// @file Which files in a folder are those of a result.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace type21 {

/// What run.json says of its run.
struct RunMark {
    std::string run_id, status;  ///< empty where run.json does not have them
};
/// Nothing when the folder has no run.json of type21, or only a link to one.
std::optional<RunMark> read_run_mark(const std::filesystem::path& folder);

/// The files that carry a run id: CSVs of a run, .pvd and .vtu. By their names; links are none of them.
std::vector<std::filesystem::path> marked_files(const std::filesystem::path& folder);

/// The checkpoints in a folder, by their names.
std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& folder);

/// Why the folder holds something that type21 has not written, with its path; empty when there is nothing of the kind.
/// An empty folder holds nothing.
/// @throws IoError when it cannot be read
std::string foreign_content(const std::filesystem::path& folder);

/// Removes the files of a result, by their names, and then the folder if nothing else is in it.
/// @return whether the folder has gone
bool remove_result(const std::filesystem::path& folder);

}  // namespace type21
