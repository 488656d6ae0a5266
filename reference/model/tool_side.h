/// @file The tool: its nodes, whether it turns, and whether both sides are what they must be.
#pragma once

#include <string>

#include "reference/model/card_validator.h"

namespace type21 {

/// Fills main_nodes and tool_rotates. The surfaces and the rigid body exist.  Formulation 1, step 2.
void build_tool_side(const CardValidator& validator);

/// What must hold between the surfaces, the elements and the rigid body: every main node in the body (error), no
/// secondary node in it (error), no node on both sides (error; as built: D18), no main segment without area (error),
/// each segment on an element (warning). One message each.  Formulation 1, step 2; manual page, head and comment 1.
void check_sides(const CardValidator& validator);

/// An error for nodes on both sides.
/// @param nodes  as text: "3 nodes: 17, 18, 19".  Formulation 1, step 2; as built: D18.
void refuse_shared_nodes(const CardValidator& validator, const std::string& nodes);

}  // namespace type21
