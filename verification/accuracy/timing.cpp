#include "verification/accuracy/timing.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace type21::accuracy {

double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double percentile(std::vector<double> values, double share) {
    const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(values.size())));
    const size_t at = std::clamp<size_t>(rank, 1, values.size()) - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    return values[at];
}

double error_of_median(const std::vector<double>& values) {
    if (values.size() < 2) return 0;
    // Of a normal distribution the middle 80 % are 2.563 standard deviations, and the median is worth sqrt(pi / 2) less
    // than the mean.
    const double deviation = (percentile(values, 0.9) - percentile(values, 0.1)) / 2.563;
    return 1.2533 * deviation / std::sqrt(static_cast<double>(values.size()));
}

Spread spread(const std::vector<double>& values) {
    if (values.empty()) return {};
    return {percentile(values, 0), percentile(values, 0.5), percentile(values, 0.95), percentile(values, 1)};
}

void interleave(std::vector<Timed>& timed, int repeats) {
    for (int repeat = 0; repeat < repeats; ++repeat) {
        for (size_t i = 0; i < timed.size(); ++i) {
            Timed& one = timed[(i + static_cast<size_t>(repeat)) % timed.size()];
            if (one.count == 0) continue;
            const double from = thread_seconds();
            one.pass();
            one.ns.push_back(1e9 * (thread_seconds() - from) / static_cast<double>(one.count));
        }
    }
}

}  // namespace type21::accuracy
