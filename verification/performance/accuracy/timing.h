/// @file Times in one process, in turn.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "verification/support/timing.h"

namespace type21::accuracy {

/// Standard error of the median, from the middle 80 % of the values: outliers do not count. 0 for less than two.
double error_of_median(const std::vector<double>& values);

/// Times of one thing over the repeats [ns].
struct Spread {
    double least = 0, p50 = 0, p95 = 0, most = 0;
};
/// @param values  may be empty: all zeros
Spread spread(const std::vector<double>& values);

/// Something that is timed: `pass` does it `count` times.
struct Timed {
    std::function<void()> pass;
    size_t count = 0;
    std::vector<double> ns;  ///< for one, a value a repeat
};

/// Times all of them in turn, `repeats` times, each time beginning with another, so that none has the better place.
void interleave(std::vector<Timed>& timed, int repeats);

}  // namespace type21::accuracy
