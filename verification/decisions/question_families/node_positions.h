/// @file Where to put a node so that its decision is hard: on and beside the places where an answer changes.
#pragma once

#include "verification/decisions/queries/query.h"
#include "verification/decisions/question_families/draw.h"

namespace type21 {

/// Limits of a question.
struct Limits {
    double gap = 0;    ///< [length]
    double depth = 0;  ///< [length]
    double reach = 0;  ///< of proximity, 0 without [length]
};

/// A gap of 1/64 to 1/2 of a size, a depth about as large, in half of the cases a reach beyond the gap.
Limits limits_for(Draw& draw, double size);

/// A node at a corner, on an edge or centre line, at the centroid, at a limit of the weights or anywhere, of a segment
/// drawn; above or below it by nothing, by exactly a limit, or by less; in half of the cases moved by a few ulps.
DecisionQuery query_near(Draw& draw, const DecisionTool& tool, const Limits& limits);

/// Half of the coordinates get moved by up to two ulps of the largest one.
Vec3 nudged(Draw& draw, const Vec3& point);

/// Queries near the tool, each with its own limits drawn for the size.
void add_queries(Draw& draw, DecisionBlock& block, double size, int count);

}  // namespace type21
