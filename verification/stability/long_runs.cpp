#include "verification/stability/long_runs.h"

namespace type21::stability {

const std::vector<LongRunKind>& long_runs() {
    static const std::vector<LongRunKind> kinds{
        {"fold_convex", 1000000, [](const MakeContact& make, long cycles) { return circling(make, cycles, true); }},
        {"fold_concave", 1000000, [](const MakeContact& make, long cycles) { return circling(make, cycles, false); }},
        {"fold_turning", 1000000, [](const MakeContact& make, long cycles) { return turning(make, cycles); }},
        {"bounce", 1000000, [](const MakeContact& make, long cycles) { return bouncing(make, cycles, 0.0); }},
        {"bounce_damped", 1000000, [](const MakeContact& make, long cycles) { return bouncing(make, cycles, 0.1); }},
        {"rest", 100000, [](const MakeContact& make, long cycles) { return resting(make, cycles, 0.5); }},
        {"rest_near_slip", 100000, [](const MakeContact& make, long cycles) { return resting(make, cycles, 0.95); }}};
    return kinds;
}

}  // namespace type21::stability
