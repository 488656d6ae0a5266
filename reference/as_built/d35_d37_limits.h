/// @file D35, D37: two values of which the readings differ.
#pragma once

#include <numbers>

#include "reference/contact/projection.h"

namespace type21::reference::as_built {

/// As documented: a nodal normal that does not face outward, <n_V, N> <= 0, rejects the sub-triangle.
/// As built: 1e-30 takes the place of <n_V, N> (CornerSlopes::raise), and the sub-triangle often takes the node.
/// @param limits  those of a cycle.  Formulation 12, step 2; Formulation 3, step 1.
/// @manual departure D35
inline void lift_leaning_normals(ProjectionLimits<double>& limits) {
    limits.lift_leaning = true;
}

/// As documented: an element is to be divided where the tool radius is below NRadm times its longest edge.
/// As built: below root 2 times that [-].  Formulation 12, step 2; Formulation 9, step 15.
/// @manual departure D37
inline constexpr double division_radius_factor = std::numbers::sqrt2;

}  // namespace type21::reference::as_built
