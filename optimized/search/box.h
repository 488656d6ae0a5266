/// @file Boxes along the axes of the tool frame.
#pragma once

#include <limits>

#include "optimized/projection/vector3.h"

namespace type21::optimized {

struct Box {
    V3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
    V3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity()};

    void extend(const V3& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    void extend(const Box& b) {
        extend(b.low);
        extend(b.high);
    }
    void grow(double by) {
        low = low - V3{by, by, by};
        high = high + V3{by, by, by};
    }
    void clip(const Box& b) {
        low = {std::max(low.x, b.low.x), std::max(low.y, b.low.y), std::max(low.z, b.low.z)};
        high = {std::min(high.x, b.high.x), std::min(high.y, b.high.y), std::min(high.z, b.high.z)};
    }
    bool holds(const V3& p) const {
        return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y && low.z <= p.z && p.z <= high.z;
    }
    bool meets(const Box& b) const {
        return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z &&
               b.low.z <= high.z;
    }
    V3 middle() const { return (low + high) * 0.5; }
};

}  // namespace type21::optimized
