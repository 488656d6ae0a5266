/// @file D13: the stiffness on which a tool is damped.
#pragma once

#include "reference/contact/tool_damping.h"

namespace type21::reference::as_built {

/// As documented: the sum of k over the nodes in contact.
/// As built: the sum of k + C/dt1, in rotation likewise.
/// @param step  sums of k + C/dt1
/// @return translation [force/length], rotation [moment].  Formulation 12, step 2; Formulation 9, step 16.
/// @manual departure D13
inline ToolStiffness tool_damping_stiffness(const ToolStiffness& /*contact*/, const ToolStiffness& step) {
    return step;
}

}  // namespace type21::reference::as_built
