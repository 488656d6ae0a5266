/// @file Columns that share a unit, and the scale of the differences of a column.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "verification/results/tables/csv_table.h"

namespace type21 {

/// "impulse", "energy", "length", "velocity", "acceleration", "angular velocity", "reaction", "reaction moment",
/// "moment impulse"; any other column is a group of its own.
std::string unit_group(std::string_view column);

/// Scale of each value column of the reference: max(its largest |value|, 1e-3 x the largest |value| of its unit group).
/// A component that cancels (FNY beside |FNY|) is the rounding of its group. With the tolerance 1e-9 the floor is
/// 1e-12 of the group, which sums of doubles over a few hundred cycles reach. NaN and infinity do not count. 0
/// where the whole group is 0.
///
/// A column that stays below tolerance x the largest of its group (1e-3 at most) in both histories is nothing at that
/// tolerance, such as a component that is 0 by symmetry: its scale is the largest of the group.
std::vector<double> column_scales(const CsvTable& reference, const CsvTable& ours, double tolerance);

}  // namespace type21
