/// @file Repeats in turn, and their quantiles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verification/support/timing.h"

namespace type21::bench {

/// Methods that are compared: each runs once a round, in turn, so that what slows the machine slows all of them.
class Rounds {
  public:
    /// @param run    does its work once and returns the nanoseconds per node
    /// @param times  runs so often in a round; negative: takes part in every so many rounds only,
    ///               and not in the first to warm up
    void add(std::string name, std::function<double()> run, int times = 1);
    /// One round to warm up, which is not counted, then `repeats`, fewer (but 3) when they take longer.
    /// @param seconds  of wall time
    /// @return rounds that count
    int run(int repeats, double seconds = 1e9);
    bool has(const std::string& name) const;

    /// Quantiles of the repeats [ns].
    /// @throws std::invalid_argument where nothing of this name was timed
    TimingSpread of(const std::string& name) const;
    /// Median of the one over the median of the other; and the same of minima.
    double of_medians(const std::string& slow, const std::string& fast) const;
    double of_minima(const std::string& slow, const std::string& fast) const;

  private:
    struct Method {
        std::string name;
        std::function<double()> run;
        int times = 1;
        std::vector<double> times_taken;
    };
    const std::vector<double>& times_of(const std::string& name) const;
    std::vector<Method> methods_;
};

/// Keeps a value from being optimized away.
template <class Value>
void keep(const Value& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

}  // namespace type21::bench
