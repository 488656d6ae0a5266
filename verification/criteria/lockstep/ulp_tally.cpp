#include "verification/criteria/lockstep/ulp_tally.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace type21 {

void UlpTally::add(double difference, double scale, const LockstepPlace& place) {
    ++compared_;
    if (difference == 0) {
        ++equal_;
        return;
    }
    const double ulps = scale > 0 && !std::isnan(difference) ? difference / (ulp_of_one * scale)
                                                             : std::numeric_limits<double>::infinity();
    if (ulps > largest_) {
        largest_ = ulps;
        where_ = place;
    }
    int bin = ulps < fine / 16 ? static_cast<int>(ulps * 16) : 0;
    if (ulps >= fine / 16) {
        const double above = std::log2(ulps / (fine / 16));
        bin = fine + (above < coarse - 1 ? static_cast<int>(above) : coarse - 1);
    }
    ++bins_[static_cast<size_t>(bin)];
}

UlpTally& UlpTally::operator+=(const UlpTally& other) {
    compared_ += other.compared_;
    equal_ += other.equal_;
    for (size_t i = 0; i < bins_.size(); ++i)
        bins_[i] += other.bins_[i];
    if (other.largest_ > largest_) {
        largest_ = other.largest_;
        where_ = other.where_;
    }
    return *this;
}

double UlpTally::upper_end(int bin) {
    if (bin < fine) return (bin + 1) / 16.0;
    return fine / 16 * std::exp2(bin - fine + 1);
}

double UlpTally::percentile(double share) const {
    long below = equal_;
    const auto wanted = static_cast<long>(std::ceil(share * static_cast<double>(compared_)));
    if (below >= wanted) return 0;
    for (int bin = 0; bin < fine + coarse; ++bin) {
        below += bins_[static_cast<size_t>(bin)];
        if (below >= wanted) return std::min(upper_end(bin), largest_);
    }
    return largest_;
}

}  // namespace type21
