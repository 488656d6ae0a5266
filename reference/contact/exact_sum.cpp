#include "reference/contact/exact_sum.h"

#include <cmath>
#include <utility>

namespace type21 {

void ExactSum::add(double value) {
    size_t kept = 0;
    for (double partial : partials_) {
        if (std::abs(value) < std::abs(partial)) std::swap(value, partial);
        const double high = value + partial;
        const double low = partial - (high - value);
        if (low != 0) partials_[kept++] = low;
        value = high;
    }
    partials_.resize(kept);
    partials_.push_back(value);
}

double ExactSum::value() const {
    if (partials_.empty()) return 0;
    // From the largest partial down; the first that leaves a remainder decides the rounding, and the sign of what is
    // below it matters only when the remainder is exactly half a unit in the last place.
    size_t i = partials_.size() - 1;
    double sum = partials_[i];
    double low = 0;
    while (i > 0) {
        const double larger = sum;
        const double next = partials_[--i];
        sum = larger + next;
        low = next - (sum - larger);
        if (low != 0) break;
    }
    if (i > 0 && ((low < 0 && partials_[i - 1] < 0) || (low > 0 && partials_[i - 1] > 0))) {
        const double doubled = low * 2;
        const double moved = sum + doubled;
        if (moved - sum == doubled) sum = moved;
    }
    return sum;
}

}  // namespace type21
