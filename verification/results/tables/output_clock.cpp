#include "verification/results/tables/output_clock.h"

namespace type21 {

bool OutputClock::due(double time, double step, bool last) {
    if (first_) {
        first_ = false;
        next_ = time + interval_;
        return true;
    }
    if (interval_ <= step) {
        next_ = time;  // should the step shrink below the interval, the count goes on from here
        return true;
    }
    if (time < next_) return last;
    // Added one by one: the output times round as accumulated sums do. At most a few turns, since interval > step.
    while (next_ <= time)
        next_ += interval_;
    return true;
}

}  // namespace type21
