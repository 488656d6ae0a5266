/// @file A comparison for CI.
#pragma once

#include <string>

#include "verification/results/compare/compare_folders.h"

namespace type21 {

/// JUnit XML: one test case a column of each file, and one for each mismatch that belongs to no column. Hints are in
/// the text of the failures.
std::string comparison_junit(const FolderComparison& comparison);

}  // namespace type21
