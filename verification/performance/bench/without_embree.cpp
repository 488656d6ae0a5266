/// @file In place of closest_embree.cpp where there is no Embree.
#include <stdexcept>

#include "verification/performance/bench/closest_point.h"

namespace type21::bench {

bool has_embree() {
    return false;
}

std::unique_ptr<ClosestPoint> closest_by_embree(const SurfaceMesh&, double) {
    throw std::logic_error("bench: this program was built without Embree");
}

}  // namespace type21::bench
