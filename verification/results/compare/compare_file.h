/// @file Compares a result folder with one file: a time-history file of OpenRadioss, or a CSV.
#pragma once

#include <filesystem>

#include "verification/results/compare/compare_folders.h"
#include "verification/results/compare/reference_tables.h"

namespace type21 {

/// Interfaces and nodes are matched by id, times as match_rows() does; reference_tables() says what is read.
/// @throws T01Error, CsvError for a file that cannot be read as that
/// @throws UnclearReference, WrongOption
FolderComparison compare_file(const std::filesystem::path& ours, const std::filesystem::path& reference,
                              const FolderOptions& options);

}  // namespace type21
