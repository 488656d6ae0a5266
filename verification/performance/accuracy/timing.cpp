#include "verification/performance/accuracy/timing.h"

#include <cmath>

namespace type21::accuracy {

double error_of_median(const std::vector<double>& values) {
    if (values.size() < 2) return 0;
    // Of a normal distribution the middle 80 % are 2.563 standard deviations, and the median is worth sqrt(pi / 2) less
    // than the mean.
    const double deviation = (percentile(values, 0.9) - percentile(values, 0.1)) / 2.563;
    return 1.2533 * deviation / std::sqrt(static_cast<double>(values.size()));
}

void interleave(std::vector<Timed>& timed, int repeats) {
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (size_t i = 0; i < timed.size(); ++i) {
            Timed& one = timed[(i + static_cast<size_t>(repeat)) % timed.size()];
            if (one.count == 0) continue;
            const Watch watch(true);
            one.pass();
            one.ns.push_back(watch.nanoseconds() / static_cast<double>(one.count));
        }
    }
}

}  // namespace type21::accuracy
