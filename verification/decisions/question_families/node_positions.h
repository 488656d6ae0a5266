/// @file Positions of nodes whose decisions are hard: on and beside the places where the answer changes.
#pragma once

#include "reference/contact/retained_impact.h"
#include "verification/decisions/queries/decision_block.h"
#include "verification/decisions/question_families/draw.h"

namespace type21 {

/// How far the node of a query is seen: gap, DEPTH and the reach of proximity (0: none) [length].
using QueryReach = reference::ContactReach<double>;

/// A gap of 1/64 to 1/2 of a size, a depth about as large, in half of the cases a proximity beyond the gap.
QueryReach reach_for(Draw& draw, double size);

/// The query of a node at this point, with the documented limits.
inline ContactQuery query_at(const Vec3& point, const QueryReach& reach) {
    return {point, reach.gap, reach.depth, reach.proximity};
}

/// A node near a segment that is drawn: at a corner, on an edge or centre line, at the centroid, at a limit of the
/// weights or anywhere. Its height is 0, exactly the gap, DEPTH or the proximity, or less. In half of the cases it is
/// then moved by a few ulps.
ContactQuery query_near(Draw& draw, const DecisionTool& tool, const QueryReach& reach);

/// Half of the coordinates are moved by up to two ulps of the largest one.
Vec3 nudged(Draw& draw, const Vec3& point);

/// Queries near the tool, each with its own reach drawn for the size.
void add_queries(Draw& draw, DecisionBlock& block, double size, int count);

}  // namespace type21
