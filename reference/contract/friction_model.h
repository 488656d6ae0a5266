/// @file Friction by pairs of parts (/FRICTION).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh.h"

namespace type21 {

/// One part pair of /FRICTION, or its default.
struct FrictionCoefficients {
    double fric = 0;
    std::array<double, 6> c{};
};

struct FrictionPair {
    int part_a = -1;
    int part_b = -1;
    FrictionCoefficients coefficients;
};

/// /FRICTION: replaces the friction fields of the interfaces that name it.
struct FrictionModel {
    Id id = 0;
    std::string title;
    int ifric = 0;
    int ifiltr = 0;
    double xfreq = 0;
    FrictionCoefficients fallback;
    std::vector<FrictionPair> pairs;
    int line = 0;
};

}  // namespace type21
