/// @file Quantities of an interface at time 0, for `type21 check`.
#pragma once

#include <vector>

#include "reference/cycle/contact.h"

namespace type21 {

struct Range {
    double smallest = 0;
    double largest = 0;
};

struct TimeZero {
    Range gap;                                     ///< g0 over the secondary nodes [length]
    double depth = 0;                              ///< as resolved [length]
    Range stiffness;                               ///< k over the secondary nodes, at full contact [force/length]
    Range mass;                                    ///< of a secondary node [mass]
    double total_mass = 0;                         ///< of the secondary nodes [mass]
    std::vector<InitialPenetration> penetrations;  ///< deepest first
};

TimeZero time_zero(const HostScene& scene, int interface);

}  // namespace type21
