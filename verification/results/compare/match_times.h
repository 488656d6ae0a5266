/// @file Pairs the times of two histories, before their rows are paired.
#pragma once

#include <string>
#include <vector>

#include "verification/results/compare/match_rows.h"

namespace type21 {

/// A time of the thinner history and where it lies in the fuller one.
struct TimePair {
    size_t thin = 0;    ///< index into the thinner history's times
    size_t full = 0;    ///< index into the fuller one's
    double weight = 0;  ///< 0: the very same time; otherwise (1 - weight) of `full` and weight of `full` + 1
};

struct TimeMatch {
    std::vector<TimePair> pairs;
    bool interpolated = false;
    std::vector<std::string> notes, mismatches;
};

/// @param thin, full             ascending, thin.size() <= full.size(), neither empty [time]
/// @param thin_name, full_name   for the messages
/// @param rounding               of the times, see time_tolerance() [-]
TimeMatch match_times(const std::vector<double>& thin, const std::string& thin_name, const std::vector<double>& full,
                      const std::string& full_name, const TimeWindow& window, double rounding = 0);

}  // namespace type21
