/// @file What a column of another program's table is, told by its header: "INTER 1 punch FNX", "node 1012 DZ".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "verification/results/compare/run_tables.h"

namespace type21 {

/// A column of ours.
struct ColumnPlace {
    std::string file;          ///< "interface_1.csv", "nodes.csv", "rbody.csv"
    std::optional<Id> object;  ///< node or rigid body
    std::string column;        ///< "FNX"
};

/// The name of a column of a history in a text, whatever its case: "fnx" is FNX. Empty where there is none.
std::string known_column(std::string_view text);

/// The converter th_to_csv of OpenRadioss puts all histories into one table; the header of a column holds the id of an
/// interface or node, its title or that of the group, and the variable, which comes last: a name, or "var" and the code
/// of the time-history format. Other programs write the same in another order. The id is the number behind a word
/// for the kind (INTER, NODE, RBODY), else the first word when it is a number, else the last number. Without a
/// number the title of an interface of the run tells, or the only interface.
/// @return nothing when the header names no variable of ours, or no object
std::optional<ColumnPlace> place_of_header(std::string_view header, RunTables& run);

}  // namespace type21
