/// @file The penetration offset P0: what of a penetration is forgiven, and for how long (chapter 6 of the formulation).
#pragma once

#include <algorithm>
#include <cmath>

namespace type21::reference {

/// What a node remembers of its impact.  Formulation 6, step 5.
struct PenetrationHistory {
    double offset = 0;  ///< P0 [length]
    int cycles = 0;     ///< consecutive cycles retained in contact with p_g > 0
};

template <class Archive>
void visit_state(Archive& archive, PenetrationHistory& history) {
    auto& [offset, cycles] = history;
    archive(offset, cycles);
}

/// P0 at time 0: Inacti 5 forgives the whole penetration, 6 a little more, all others nothing.
///   5: P0 = p_g      6: P0 = p_g + 0.05 (g + DEPTH - p_g)
/// @param penetration  p_g at time 0 [length]
/// @param gap          g [length]
/// @param depth        DEPTH [length]
/// @return P0 [length], >= 0.  Formulation 6, step 1; manual page, comment 9.
/// @manual field Inacti; comment 9
inline double initial_offset(int inacti, double penetration, double gap, double depth) {
    if (penetration <= 0) return 0;
    if (inacti == 5) return penetration;
    if (inacti == 6) return penetration + 0.05 * (gap + depth - penetration);
    return 0;
}

/// P0 of the next cycle: it follows a decreasing penetration by 5 % a cycle and never grows.
///   P0 <- min(P0, 0.95 P0 + 0.05 p_g),   with p_g + 0.05 |g - p_g| in place of p_g for Inacti 6
/// @param offset       P0 so far [length]
/// @param inacti       Inacti as it acts
/// @param penetration  p_g [length]
/// @param gap          g [length]
/// @return P0 [length], <= offset.  Formulation 6, step 3.
/// @manual field Inacti; comment 9
inline double relaxed_offset(double offset, int inacti, double penetration, double gap) {
    const double target = inacti == 6 ? penetration + 0.05 * std::abs(gap - penetration) : penetration;
    return std::min(offset, 0.95 * offset + 0.05 * target);
}

/// Inacti as it acts on later impacts: that of the card.
/// @param any_penetrates  some node penetrates at time 0
/// @return Inacti.  Formulation 6, step 3; as built: D26.
inline int inacti_of_later_impacts(int inacti, [[maybe_unused]] bool any_penetrates) {
    return inacti;
}

/// p = max(0, p_g - P0)
/// @param penetration  p_g [length]
/// @param offset       P0 [length]
/// @return p [length], >= 0.  Formulation 6, step 3.
inline double effective_penetration(double penetration, double offset) {
    return std::max(0.0, penetration - offset);
}

/// Whether the stiffness acts: where p = 0 it does only in the first cycle of an impact (so that damping acts), and not
/// at time 0 with Inacti 5 and 6.
/// @param effective  p [length]
/// @param cycles     of this impact, this one included
/// @param time_zero  this is the cycle of time 0.  Formulation 6, step 4.
inline bool stiffness_acts(double effective, int cycles, int inacti, bool time_zero) {
    if (effective > 0) return true;
    const bool forgiven = time_zero && (inacti == 5 || inacti == 6);
    return cycles == 1 && !forgiven;
}

}  // namespace type21::reference
