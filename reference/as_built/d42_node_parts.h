/// @file D42: which part a node of several parts has under /FRICTION.
#pragma once

#include <vector>

#include "reference/contract/scene.h"

namespace type21::reference::as_built {

/// As documented: the part of the node's first segment in the surface.
/// As built: of the parts of the node's segments that a pair of the /FRICTION names, the last one of the deck.
/// @return like SecondarySide::node, index into ContactModel::parts, -1: none is named.  Formulation 12, step 2;
/// Formulation 8, step 1.
/// @manual departure D42
std::vector<int> node_parts(const ContactModel& model, const Interface& interface);

}  // namespace type21::reference::as_built
