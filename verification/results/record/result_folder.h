/// @file The folder that a run writes into.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace type21 {

/// The folder cannot be used; the message says why and what to do. Exit code 1.
struct FolderError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Creates the folder and removes what an earlier run left in it (run.json, interface_*.csv, nodes.csv, rbody.csv, the
/// files of paraview/).
/// CSV files of these names without a run.json may be measured data, such as those of a case: the folder is refused,
/// never removed.
/// @throws FolderError
void prepare_folder(const std::filesystem::path& folder);

}  // namespace type21
