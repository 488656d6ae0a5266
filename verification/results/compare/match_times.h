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

/// The times of one history.
struct TimesOf {
    const std::vector<double>& times;  ///< ascending, not empty [time]
    std::string name;                  ///< for the messages
    bool may_go_on = false;            ///< beyond the other: a note, and no mismatch
};

/// @param thin, full  thin.times.size() <= full.times.size()
/// @param rounding    of the times, see time_tolerance() [-]
TimeMatch match_times(const TimesOf& thin, const TimesOf& full, const TimeWindow& window, double rounding = 0);

}  // namespace type21
