/// @file The histories of a time-history file in the form of ours.
#pragma once

#include <string>
#include <vector>

#include "verification/results/t01/t01_file.h"
#include "verification/results/tables/csv_table.h"

namespace type21 {

/// The history of one interface, or of the nodes of one group.
struct T01Table {
    std::string name;  ///< "flat_pressT01, interface 1", "flat_pressT01, nodes of group 2 'blank'"
    std::string ours;  ///< the file of a run that has the same: "interface_1.csv", "nodes.csv"
    CsvTable table;
};

struct T01Tables {
    std::vector<T01Table> tables;
    std::vector<std::string> notes;  ///< groups and variables that are left out, and why
};

/// Interfaces are matched by id, whichever group names them; nodes keep their groups, since those differ in variables.
/// Times and values of a file of single precision carry its rounding: CsvTable::rounding.
T01Tables tables_of(const T01File& file);

}  // namespace type21
