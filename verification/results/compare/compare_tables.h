/// @file Compares two histories column by column: the largest difference, its place, and whether it is allowed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/results/compare/match_rows.h"

namespace type21 {

/// 1e-9 of the scale of a column: the measured histories are doubles of the same formulas in another order of
/// operations.
inline constexpr double default_tolerance = 1e-9;

struct CompareOptions {
    double tolerance = default_tolerance;
    std::vector<std::string> columns{};  ///< only these; empty: all
    std::vector<std::string> exclude{};  ///< none of these
    std::vector<Id> objects{};           ///< only these nodes; empty: all
    TimeWindow window{};
    bool shorter_reference = false;  ///< see match_rows()
};

/// One row of one column that differs by more than the tolerance.
struct Difference {
    double time = 0;           ///< [time]
    std::optional<Id> object;  ///< in a file of nodes
    double ours = 0;           ///< [unit of the column]
    double reference = 0;      ///< likewise
};

struct ColumnResult {
    std::string column;
    double difference = 0;     ///< largest |ours - reference|, infinity for a NaN [unit of the column]
    double scale = 0;          ///< column_scales() [unit of the column]
    double scaled = 0;         ///< difference / scale, 0 for 0/0, infinity for x/0 [-]
    double time = 0;           ///< of the largest difference [time]
    std::optional<Id> object;  ///< of the largest difference, in a file of nodes
    double ours = 0;           ///< there
    double reference = 0;      ///< there
    double tolerance = 0;
    bool ok = false;
    std::optional<Difference> first;  ///< the earliest above the tolerance
    std::string remark;               ///< "not a number ..." ; empty if there is none
};

struct TableResult {
    std::string ours, reference;  ///< file names
    size_t rows = 0;              ///< compared
    std::vector<ColumnResult> columns;
    Coverage coverage;
    std::vector<std::string> notes;
    std::vector<std::string> mismatches;  ///< missing columns, rows without partner, ...
    std::vector<std::string> hints;       ///< what may be behind a difference: units, signs, ids, ...

    bool ok() const;
    /// The column with the largest scaled difference; nullptr when none was compared.
    const ColumnResult* worst() const;
};

/// Every chosen column of the reference. Columns that only ours has are left out; those of the reference must be there.
TableResult compare_tables(const CsvTable& ours, const CsvTable& reference, const CompareOptions& options);

}  // namespace type21
