/// @file One number out of a history.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "verification/criteria/cases/case_file.h"
#include "verification/results/tables/csv_table.h"

namespace type21 {

/// The history does not have the value that a criterion names.
struct NoValue : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// @param object  node or body; needed when and only when the file has such a column
/// @return at a time: the row there (times match as in match_rows), otherwise linear between its neighbours
/// @throws NoValue
double value_at(const CsvTable& table, const std::string& column, const At& at, std::optional<Id> object);

}  // namespace type21
