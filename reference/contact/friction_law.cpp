#include "reference/contact/friction_law.h"

#include <algorithm>
#include <cmath>

namespace type21::reference {

namespace {

/// One factor times another; 0 where the first is 0, also when the second has overflowed.
double times(double one, double other) {
    return one == 0 ? 0.0 : one * other;
}

double viscous(const FrictionCoefficients& f, double p, double s) {
    const auto& c = f.c;
    return f.fric + c[0] * p + c[1] * s + c[2] * p * s + c[3] * p * p + times(c[4], s * s);
}

double darmstadt(const FrictionCoefficients& f, double p, double s) {
    const auto& c = f.c;
    return f.fric + times(p * p, times(c[0], std::exp(c[1] * s))) + times(p, times(c[2], std::exp(c[3] * s))) +
           times(c[4], std::exp(c[5] * s));
}

double renard(const FrictionCoefficients& f, double s) {
    const auto& c = f.c;
    if (s <= c[4]) {
        const double x = s / c[4];
        return c[0] + (c[2] - c[0]) * x * (2.0 - x);
    }
    if (s < c[5]) {
        const double y = (s - c[4]) / (c[5] - c[4]);
        return c[2] + (c[3] - c[2]) * y * y * (3.0 - 2.0 * y);
    }
    const double excess = s - c[5];
    return c[1] - 1.0 / (1.0 / (c[1] - c[3]) + excess * excess);
}

double exponential_decay(const FrictionCoefficients& f, double s) {
    return f.c[0] + times(f.fric - f.c[0], std::exp(-f.c[1] * s));
}

/// Not below the smallest; what is not finite stays as it is.
double raised(double mu) {
    return std::isfinite(mu) ? std::max(mu, smallest_friction_coefficient) : mu;
}

}  // namespace

double friction_coefficient(int ifric, const FrictionCoefficients& coefficients, double pressure, double speed) {
    switch (ifric) {
        case 1:
            return raised(viscous(coefficients, pressure, speed));
        case 2:
            return raised(darmstadt(coefficients, pressure, speed));
        case 3:
            return raised(renard(coefficients, speed));
        case 4:
            return raised(exponential_decay(coefficients, speed));
        default:
            return std::max(coefficients.fric, 0.0);
    }
}

size_t overflowing_coefficient(int ifric, const FrictionCoefficients& coefficients, double speed) {
    const auto& c = coefficients.c;
    const auto overflows = [&](size_t rank) { return !std::isfinite(std::exp(c[rank] * speed)); };
    switch (ifric) {
        case 1:
            return 4;
        case 2:
            if (c[0] != 0 && overflows(1)) return 1;
            if (c[2] != 0 && overflows(3)) return 3;
            return c[4] != 0 && overflows(5) ? 5 : 0;
        case 3:
            return c[4] == 0 ? 4 : 5;
        default:
            return 1;
    }
}

FrictionCoefficients friction_coefficients(const ContactModel& model, const Interface& interface, int part_secondary,
                                           int part_main) {
    if (interface.friction_model < 0) {
        FrictionCoefficients card;
        card.fric = interface.fric;
        for (size_t i = 0; i < card.c.size(); ++i)
            card.c[i] = interface.c[i];
        return card;
    }
    const FrictionModel& friction = model.friction_models[static_cast<size_t>(interface.friction_model)];
    for (const FrictionPair& pair : friction.pairs) {
        const bool as_listed = pair.part_a == part_secondary && pair.part_b == part_main;
        const bool swapped = pair.part_a == part_main && pair.part_b == part_secondary;
        if (as_listed || swapped) return pair.coefficients;
    }
    return friction.fallback;
}

double friction_temperature(const Interface& interface, double blank, double tool) {
    return interface.ascalef * (0.5 * (blank + tool));
}

}  // namespace type21::reference
