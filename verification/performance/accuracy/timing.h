/// @file Several things timed in one process, in turn.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "verification/support/timing.h"

namespace type21::accuracy {

/// Standard error of the median, from the middle 80 % of the values: outliers do not count. 0 for less than two.
double error_of_median(const std::vector<double>& values);

/// Something that is timed: `pass` does it `count` times.
struct Timed {
    std::function<void()> pass;
    size_t count = 0;
    std::vector<double> ns;  ///< time of one, a value for each repeat [ns]
};

/// Times all of them in turn, `repeats` times. Each repeat begins with another one, so that none has the better place.
void interleave(std::vector<Timed>& timed, int repeats);

}  // namespace type21::accuracy
