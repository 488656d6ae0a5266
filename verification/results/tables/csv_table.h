/// @file A history file read back: columns by name, rows by time and object.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reference/contract/mesh.h"
#include "verification/results/tables/csv_text.h"

namespace type21 {

/// What a table says of itself, apart from its rows.
struct CsvHeading {
    std::string file;
    bool has_object = false;           ///< a second column names nodes, bodies or elements
    std::string object_name{};         ///< of that column: "node", "rbody" or "element"; empty without it
    std::vector<std::string> columns;  ///< the value columns, without their units
    double rounding = 0;  ///< relative, of times and values: that of floats, or of digits that were not printed; else 0
    std::string rounded_to{};          ///< where that comes from: "7 digits", "single precision"; empty without it
    std::string time_unit{};           ///< that the header names: "ms" of `time [ms]`; else empty
    std::vector<std::string> units{};  ///< per column, likewise; empty where no header has one
    std::vector<std::string> notes{};  ///< what was understood beyond a plain CSV: "decimal commas", ...
};

/// A history: `time` first, then maybe `node`, `rbody` or `element`, then values.
struct CsvTable : CsvHeading {
    std::vector<double> time;                 ///< per row
    std::vector<Id> object;                   ///< per row; empty without has_object
    std::vector<std::vector<double>> values;  ///< per column, per row

    size_t rows() const { return time.size(); }
    std::optional<size_t> column(const std::string& name) const;
    /// Unit that the header names for a column; empty without one.
    std::string unit(size_t column) const { return units.empty() ? std::string() : units[column]; }
};

struct CsvReading {
    std::string time_name = "time";  ///< header of the times, where another program calls them otherwise
    bool unique_names = true;        ///< two columns of one name are an error
};

/// Reads a CSV of ours, of a spreadsheet, of numpy or pandas, or of the converter of OpenRadioss: quotes, separators
/// and comments as CsvText says. Upper and lower case do not matter in `time` and `node`; `time [s]`, `time (s)` and
/// `time / s` name a unit, and so does every other column. A column without a name before `time` is an index and is
/// left out. With ';' or tab between the cells, a comma in a number is a decimal comma.
/// A table whose numbers all have N significant digits, 4 to 14, is taken as printed with N: see `rounding`.
/// @throws CsvError on a missing file, a row with another number of cells, or a cell that is not a number ("nan" and
/// "inf" are).
CsvTable read_csv(const std::filesystem::path& path, const CsvReading& reading = {});

/// "FNX" and "kN s" of "FNX [kN s]", "FNX (kN s)" or "FNX / kN s"; an empty unit without one.
struct NameAndUnit {
    std::string name, unit;
};
NameAndUnit name_and_unit(std::string_view header);

/// Part of the time axis that counts, ends included [time].
struct TimeWindow {
    double from = -std::numeric_limits<double>::infinity();
    double until = std::numeric_limits<double>::infinity();
};

/// The rows within the window whose object is in the list (all when the list is empty).
CsvTable filtered(const CsvTable& table, const TimeWindow& window, const std::vector<Id>& objects);

}  // namespace type21
