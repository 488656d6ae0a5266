/// @file Stop-watch and quantiles, for all that measures time.
#pragma once

#include <ctime>
#include <vector>

namespace type21 {

/// Of one thread its processor time, since others may share the machine; of several the time on the wall.
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

/// The smallest value that at least this share of the values does not exceed. @param values  not empty
double percentile(std::vector<double> values, double share);

}  // namespace type21
