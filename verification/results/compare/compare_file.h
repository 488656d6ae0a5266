/// @file Compares a result folder with one file: a time-history file of OpenRadioss, or a CSV.
#pragma once

#include <filesystem>

#include "verification/results/compare/compare_folders.h"

namespace type21 {

/// It is not clear to which interface of the run the reference belongs; the message says what to do.
struct UnclearReference : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A name that ends in .csv is a CSV with the column names of ours; everything else is read as a time-history file.
/// Interfaces and nodes are matched by id, times as match_rows() does. A CSV belongs to nodes.csv or rbody.csv when its
/// second column is `node` or `rbody`, otherwise to the interface of its name (interface_<id>.csv), or to the only one
/// of the run. The tolerance is that of the options, else default_tolerance, or twice the rounding of the floats in a
/// file of single precision where that is more.
/// @throws T01Error, CsvError for a file that cannot be read as that
/// @throws UnclearReference
FolderComparison compare_file(const std::filesystem::path& ours, const std::filesystem::path& reference,
                              const FolderOptions& options);

}  // namespace type21
