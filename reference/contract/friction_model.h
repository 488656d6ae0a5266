/// @file Friction by pairs of parts (/FRICTION).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh.h"

namespace type21 {

/// One part pair of /FRICTION, or its default.
struct FrictionCoefficients {
    double fric = 0;            ///< Fric [-]
    std::array<double, 6> c{};  ///< C1..C6, in the units that the law asks for
};

/// Coefficients of two parts, in any order.
struct FrictionPair {
    int part_a = -1;  ///< index into ContactModel::parts
    int part_b = -1;
    FrictionCoefficients coefficients;
};

/// /FRICTION: replaces the friction fields of the interfaces that name it.  Formulation 8, step 1.
struct FrictionModel {
    Id id = 0;
    std::string title;
    int ifric = 0;
    int ifiltr = 0;
    double xfreq = 0;               ///< [-], or [1/time] with Ifiltr 3
    FrictionCoefficients fallback;  ///< of parts that are in no pair
    std::vector<FrictionPair> pairs;
    int line = 0;  ///< of the deck, 0 if none
};

}  // namespace type21
