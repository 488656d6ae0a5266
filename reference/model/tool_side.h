/// @file The tool: its nodes, whether it turns, and whether both sides are what they must be.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Fills main_nodes and tool_rotates. The surfaces and the rigid body exist.
void build_tool_side(const CardValidator& judge);

/// What must hold between the surfaces, the elements and the rigid body: every main node in the body (error), no
/// secondary node in it (error), no node on both sides (error, D18: warning), no main segment without area (error),
/// each segment on an element (warning). One message each. Source: page, head and comment 1; formulation 12 (D18)
void check_sides(const CardValidator& judge);

}  // namespace type21
