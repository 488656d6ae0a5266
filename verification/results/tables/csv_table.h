/// @file A history file read back: columns by name, rows by time and object.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/contract/mesh.h"

namespace type21 {

/// The file is not a history: the message has file and line.
struct CsvError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A history: `time` first, then maybe `node`, `rbody` or `element`, then values.
struct CsvTable {
    std::string file;
    bool has_object = false;                  ///< a second column names nodes, bodies or elements
    std::string object_name{};                ///< of that column: "node", "rbody" or "element"; empty without it
    std::vector<std::string> columns;         ///< the value columns
    std::vector<double> time;                 ///< per row
    std::vector<Id> object;                   ///< per row; empty without has_object
    std::vector<std::vector<double>> values;  ///< per column, per row
    double rounding = 0;  ///< relative, of times and values: that of the floats of a file of single precision, else 0

    size_t rows() const { return time.size(); }
    std::optional<size_t> column(const std::string& name) const;
};

/// @throws CsvError on a missing file, a row with another number of cells, or a cell that is not a number ("nan" and
/// "inf" are).
CsvTable read_csv(const std::filesystem::path& path);

/// Part of the time axis that counts, ends included [time].
struct TimeWindow {
    double from = -std::numeric_limits<double>::infinity();
    double until = std::numeric_limits<double>::infinity();
};

/// The rows within the window whose object is in the list (all when the list is empty).
CsvTable filtered(const CsvTable& table, const TimeWindow& window, const std::vector<Id>& objects);

}  // namespace type21
