#include "reference/contact/friction_law.h"

namespace type21::reference {

double coulomb_coefficient(const Model& model, const Interface& interface, int part_secondary, int part_main) {
    if (interface.friction_model < 0) return interface.fric;
    const FrictionModel& friction = model.friction_models[static_cast<size_t>(interface.friction_model)];
    for (const FrictionPair& pair : friction.pairs) {
        const bool as_listed = pair.part_a == part_secondary && pair.part_b == part_main;
        const bool swapped = pair.part_a == part_main && pair.part_b == part_secondary;
        if (as_listed || swapped) return pair.coefficients.fric;
    }
    return friction.fallback.fric;
}

}  // namespace type21::reference
