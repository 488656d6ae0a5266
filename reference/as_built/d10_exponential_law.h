/// @file D10: the exponential friction law.
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/contact/friction_law.h"

namespace type21::reference::as_built {

/// As documented, Ifric 4: mu = C1 + (Fric - C1) e^(-C2 s), from Fric at rest to C1.
/// As built: mu = C1 - (Fric - C1) e^(-C2 s), 2 C1 - Fric at rest. The other laws are not changed.
/// @return mu [-].  Formulation 12, step 2; Formulation 8, step 7.
/// @manual departure D10
inline double friction_coefficient(int ifric, const FrictionCoefficients& f, double pressure, double speed) {
    if (ifric != 4) return reference::friction_coefficient(ifric, f, pressure, speed);
    return std::max(f.c[0] + (f.c[0] - f.fric) * std::exp(-f.c[1] * speed), smallest_friction_coefficient);
}

}  // namespace type21::reference::as_built
