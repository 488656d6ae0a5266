#include "verification/support/timing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace type21 {

double percentile(std::vector<double> values, double share) {
    const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(values.size())));
    const size_t at = std::clamp<size_t>(rank, 1, values.size()) - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    return values[at];
}

TimingSpread timing_spread(const std::vector<double>& values) {
    if (values.empty()) throw std::invalid_argument("quantiles of no values");
    return {percentile(values, 0.5), percentile(values, 0.95), percentile(values, 1), percentile(values, 0)};
}

}  // namespace type21
