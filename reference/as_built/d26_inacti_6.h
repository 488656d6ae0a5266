/// @file D26: Inacti 6 on later impacts.
#pragma once

namespace type21::reference::as_built {

/// As documented: Inacti 6 holds for every impact.
/// As built: it becomes plain (0) when no node penetrates at time 0.
/// @return Inacti as it acts.  Formulation 12, step 2; Formulation 6, step 3.
/// @manual departure D26
inline int inacti_of_later_impacts(int inacti, bool any_penetrates) {
    return any_penetrates ? inacti : 0;
}

}  // namespace type21::reference::as_built
