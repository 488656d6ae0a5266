/// @file What nodes remember of their last search.
#pragma once

#include <array>
#include <cmath>

#include "optimized/decide/vector3.h"
#include "optimized/machine.h"

namespace type21::optimized {

/// What a node remembers to be quick. It never changes an answer: it only says where to look first, and everything that
/// is concluded from it is proven for the place where the node is now.
struct Memory {
    int place = -1;    ///< sub-triangle retained last, as place_of gives it
    float radius = 0;  ///< of the ball around `from`, @see Search; > 0: quiet, < 0: steady, 0: none [length]
    V3 from;           ///< [length]

    /// Does the ball hold y? Sums of three squares are right to 3 ulp; that of a float is exact.
    bool within(const V3& y) const {
        const V3 way = y - from;
        return dot(way, way) * (1 + 1e-14) < double(radius) * double(radius);
    }
    bool quiet_at(const V3& y) const { return radius > 0 && within(y); }
    void forget() { radius = 0; }
};

/// A radius as a float that is no longer; 0 where there is none.
inline float shortened(double radius) {
    return radius > 0 ? std::nextafter(static_cast<float>(radius), 0.0F) : 0.0F;
}

/// Which of these nodes do their balls hold? All ones or all zeros; of up to eight behind the last something.
/// @param y  rows of the components
void within_balls(const Memory* memory, const std::array<const double*, 3>& y, int count, long long* within,
                  Machine machine = this_machine());

}  // namespace type21::optimized
