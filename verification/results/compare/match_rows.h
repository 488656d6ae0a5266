/// @file Pairs the rows of two histories.
#pragma once

#include <string>
#include <vector>

#include "verification/results/tables/csv_table.h"

namespace type21 {

/// One row to compare: on each side the value is (1 - weight) * values[row] + weight * values[next].
struct RowPair {
    struct Side {
        size_t row = 0;
        size_t next = 0;
        double weight = 0;
    };
    double time = 0;
    Id object = 0;
    Side ours, reference;
};

/// The times that both histories cover, within the window.
struct Coverage {
    double from = 0, until = 0;  ///< [time]
    double share = 1;            ///< of the times of ours that are in the window [-]
};

struct RowMatch {
    std::vector<RowPair> pairs;
    Coverage coverage;
    bool interpolated = false;
    std::vector<std::string> notes;       ///< for the reader
    std::vector<std::string> mismatches;  ///< each makes the comparison fail
};

/// Largest difference of two times that count as equal: 1e-6 of the smaller of the two smallest steps, because
/// accumulated sums of steps differ in the last bits and no more. 0 when neither history has two times.
/// @param rounding  relative, of times that were stored with fewer digits: they may be off by as much, but by no
///                  more than a quarter of a step
double time_tolerance(const std::vector<double>& a, const std::vector<double>& b, double rounding = 0);

/// The times of the thinner file decide. When one of them has no partner inside the overlap, the other file is
/// interpolated linearly onto them; then only the overlap counts, and an end may be off by one step. Otherwise every
/// time must have its partner, and neither file may go on beyond the other. The nodes of the reference decide: each
/// must be there at each time.
/// @param shorter_reference  ours may begin before the reference and go on behind it; not the other way round, which
///                           would be a run that stopped early
RowMatch match_rows(const CsvTable& ours, const CsvTable& reference, const TimeWindow& window = {},
                    bool shorter_reference = false);

}  // namespace type21
