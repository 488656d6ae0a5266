/// @file The histories in one reference file, in the form of ours.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "verification/results/compare/reference_changes.h"
#include "verification/results/t01/t01_tables.h"

namespace type21 {

/// It is not clear to which interface of the run the reference belongs; the message says what to do.
struct UnclearReference : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads a time-history file (T01Records) or a CSV (read_csv), told apart by their first bytes, and changes it.
///
/// A CSV whose second column is `node` or `rbody` belongs to nodes.csv or rbody.csv. Columns with our names belong to
/// the interface of the file's name (interface_<id>.csv) or to the only one of the run. Other headers are read by
/// place_of_header(); where one of them has a place, those without are left out, with a note. Where none has, they stay
/// as they are.
/// @throws T01Error, CsvError, UnclearReference, WrongOption
T01Tables reference_tables(const std::filesystem::path& reference, RunTables& run, ReferenceChanger& changer);

}  // namespace type21
