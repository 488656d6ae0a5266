#include "verification/performance/accuracy/force_error.h"

#include <cmath>
#include <limits>

#include "verification/criteria/lockstep/ulp_tally.h"
#include "verification/performance/accuracy/timing.h"

namespace type21::accuracy {

double error_in_ulps(double got, double exact) {
    const double spacing = std::nextafter(exact, std::numeric_limits<double>::infinity()) - exact;
    return std::abs(got - exact) / spacing;
}

void ForceErrors::add(double got, double exact, double scale) {
    const double ulps = error_in_ulps(got, exact);
    if (!std::isfinite(ulps)) {
        ++not_finite_;
        return;
    }
    ulps_.push_back(ulps);
    relative_.push_back(std::abs(got - exact) / exact);
    scaled_.push_back(std::abs(got - exact) / (ulp_of_one * scale));
}

double ForceErrors::at(const std::vector<double>& values, double share) {
    return values.empty() ? 0 : percentile(values, share);
}

}  // namespace type21::accuracy
