/// @file Stop-watch and quantiles of times.
#pragma once

#include <ctime>
#include <vector>

namespace type21 {

/// A stop-watch that runs from its construction. It measures the processor time of the calling thread, since others may
/// share the machine; for work on several threads it measures wall time.
class Watch {
  public:
    explicit Watch(bool one_thread) : one_thread_(one_thread), from_(now()) {}
    double nanoseconds() const { return now() - from_; }
    double seconds() const { return 1e-9 * nanoseconds(); }

  private:
    double now() const {
        timespec t{};
        clock_gettime(one_thread_ ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &t);
        return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
    }
    bool one_thread_;
    double from_;
};

/// The smallest value that at least this share of the values does not exceed.
/// @param values  not empty
/// @param share   0 to 1; 0 gives the minimum
double percentile(std::vector<double> values, double share);

/// Quantiles of the repeats of one measurement, in the unit of the values (ns).
struct TimingSpread {
    double p50 = 0, p95 = 0, max = 0, min = 0;
};
/// @throws std::invalid_argument where there is no value
TimingSpread timing_spread(const std::vector<double>& values);

}  // namespace type21
