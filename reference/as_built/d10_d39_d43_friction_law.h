/// @file D10, D39, D43: the friction coefficient.
#pragma once

#include "reference/contact/friction_law.h"

namespace type21::reference::as_built {

/// Which of the three are on.
struct FrictionLawDepartures {
    bool d10 = false, d39 = false, d43 = false;
};

/// D10. As documented, Ifric 4: mu = C1 + (Fric - C1) e^(-C2 s), from Fric at rest to C1.
///      As built: mu = C1 - (Fric - C1) e^(-C2 s), 2 C1 - Fric at rest.
/// D39. As documented, Ifric 0: mu is at least 0, also when fct_IDF is negative. As built: it is not bounded.
/// D43. As documented, Ifric 2 and 4: a term with the coefficient 0 is 0.
///      As built: 0 times an exponential that overflows is no number, and mu is the smallest coefficient. What is not
///      finite is no error in any law.
/// @return mu [-].  Formulation 12, step 2; Formulation 8, step 3; Formulation 8, step 5; Formulation 8, step 7.
/// @manual departure D10, D39, D43
double friction_coefficient(const FrictionLawDepartures& on, int ifric, const FrictionCoefficients& f, double pressure,
                            double speed);

}  // namespace type21::reference::as_built
