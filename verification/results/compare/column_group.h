/// @file Which columns of a history share a unit, and what a difference in one is measured by.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verification/results/tables/csv_table.h"

namespace type21 {

/// "impulse", "energy", "length", "velocity", "acceleration", "angular velocity", "reaction", "reaction moment",
/// "moment impulse"; a column that is none of them is a group of its own.
std::string unit_group(std::string_view column);

/// Scale of each value column of the reference: max(its largest |value|, 1e-3 x the largest |value| of its unit group).
/// A component that cancels (FNY beside |FNY|) is the rounding of its group. With the tolerance 1e-9 the floor means
/// 1e-12 of the group, and that is what double sums over a few hundred cycles keep. NaN and infinity do not count. 0
/// where the whole group is 0.
std::vector<double> column_scales(const CsvTable& reference);

}  // namespace type21
