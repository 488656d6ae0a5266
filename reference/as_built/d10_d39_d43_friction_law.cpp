#include "reference/as_built/d10_d39_d43_friction_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace type21::reference::as_built {

namespace {

/// At least the smallest coefficient, also where mu is no number. An infinite one holds like the largest number.
double raised(double mu) {
    return mu > smallest_friction_coefficient ? std::min(mu, std::numeric_limits<double>::max())
                                              : smallest_friction_coefficient;
}

}  // namespace

double friction_coefficient(const FrictionLawDepartures& on, int ifric, const FrictionCoefficients& f, double pressure,
                            double speed) {
    const auto& c = f.c;
    const double p = pressure;
    if (ifric == 0 && on.d39) return f.fric;
    if (ifric == 2 && on.d43) {
        return raised(f.fric + c[0] * std::exp(c[1] * speed) * p * p + c[2] * std::exp(c[3] * speed) * p +
                      c[4] * std::exp(c[5] * speed));
    }
    if ((ifric == 1 || ifric == 3) && on.d43) return raised(reference::friction_coefficient(ifric, f, p, speed));
    if (ifric != 4 || (!on.d10 && !on.d43)) return reference::friction_coefficient(ifric, f, pressure, speed);
    const double start = on.d10 ? 2 * c[0] - f.fric : f.fric;
    if (on.d43) return raised(c[0] + (start - c[0]) * std::exp(-c[1] * speed));
    FrictionCoefficients reversed = f;
    reversed.fric = start;
    return reference::friction_coefficient(ifric, reversed, pressure, speed);
}

}  // namespace type21::reference::as_built
