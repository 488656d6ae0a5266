/// @file Text of --as-built, as of the command line and of case.toml.
#pragma once

#include <string>

#include "reference/contract/departures.h"
#include "reference/deck/problem.h"

namespace type21 {

/// @param text  "", "none", "all", "D03,D24" or "all,-D04"
/// @param problems  gets an error with the list of available names for a name that is not in the table or not available
AsBuilt parse_as_built(const std::string& text, Problems& problems);

}  // namespace type21
