/// @file Offset, normal force and its energy (Formulation 6, steps 1 to 4; Formulation 7, steps 2 to 4).
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/contract/interface.h"

namespace type21::optimized {

/// p_g = g - delta; 0 where it is within 16 units in the last place of the node's largest coordinate, which is no
/// impact (Formulation 5, step 4). The unit is the distance to the next double above.
inline double penetration_beyond_rounding(double gap, double distance, double largest_coordinate) {
    const double up = std::nextafter(largest_coordinate, HUGE_VAL) - largest_coordinate;
    const double p_g = gap - distance;
    return p_g > 16 * up ? p_g : 0.0;
}

/// P0 that time 0 leaves behind for a penetration p > 0: Inacti 5 all of it, 6 a little more, else nothing.
/// @manual field Inacti; comment 9
inline double offset_at_start(int inacti, double p, double gap, double depth) {
    switch (inacti) {
        case 5:
            return p;
        case 6:
            return p + 0.05 * (gap + depth - p);
        default:
            return 0;
    }
}

/// P0 after one more cycle, min(P0, 0.95 P0 + 0.05 p), Inacti 6 with p + 0.05 |g - p|.
/// @manual field Inacti; comment 9
inline double offset_after(double offset, bool inacti6, double p, double gap) {
    const double toward = inacti6 ? p + 0.05 * std::abs(gap - p) : p;
    const double moved = 0.95 * offset + 0.05 * toward;
    return moved < offset ? moved : offset;
}

/// Normal spring and the energy in it.
struct Spring {
    double force = 0;   ///< F [force]
    double energy = 0;  ///< integral of F dp [energy]
};

inline Spring linear_spring(double k, double p) {
    return {k * p, 0.5 * k * p * p};
}

/// Igap 2 and Pmax, equation (5): once k times the growth of the gap exceeds P_A, the spring yields at P_A until the
/// penetration has used up the growth, then stiffens again with slope k. Its energy is that of a spring of the same
/// force, and the plateau's for the rest of the way.
/// @param growth  max(g - g0, 0) [length]   @param pmax_force  P_A = A Pmax [force]
/// @manual eq 5; field Pmax; comment 5
inline Spring yielding_spring(double k, double p, double growth, double pmax_force) {
    if (!(k * growth > pmax_force)) return linear_spring(k, p);
    Spring spring;
    spring.force = k * std::max(p - growth, 0.0) + std::min(pmax_force, k * p);
    const double elastic = spring.force / k;
    spring.energy = std::max(p - elastic, 0.0) * pmax_force + 0.5 * elastic * spring.force;
    return spring;
}

}  // namespace type21::optimized
