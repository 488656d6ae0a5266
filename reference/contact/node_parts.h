/// @file The part of a node, for the pairs of /FRICTION.
#pragma once

#include <vector>

#include "reference/contract/scene.h"

namespace type21::reference {

/// Part of each secondary node: that of the first segment of the surface that holds it and lies on an element.
/// @return like SecondarySide::node, index into ContactModel::parts, -1: none.  Formulation 8, step 1; as built: D42.
/// @manual field fric_ID
std::vector<int> node_parts(const ContactModel& model, const Interface& interface);

}  // namespace type21::reference
