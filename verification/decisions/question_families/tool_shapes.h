/// @file Small tools for queries: sheets of quads and triangles, with the nodal normals of a run.
#pragma once

#include <functional>

#include "verification/decisions/queries/decision_block.h"
#include "verification/decisions/question_families/draw.h"

namespace type21 {

/// Position of the node in column i and row j [length].
using Place = std::function<Vec3(int i, int j)>;

/// (columns x rows) quads; outward is (column direction) x (row direction). Normals are not set.
DecisionTool sheet(int columns, int rows, const Place& place);

/// A profile (x, z)(i) drawn along y at rows of a pitch: outward is up where x grows.
DecisionTool drawn_profile(int columns, int rows, double pitch, const std::function<Vec3(int i)>& profile);

/// Each quad becomes two triangles with a given probability.
void halve_quads(DecisionTool& tool, Draw& draw, double share);

/// Adds the segments of another tool, with nodes of their own.
void append(DecisionTool& tool, const DecisionTool& other);

/// Nodal normals: the sum of the unit normals of the adjacent sub-triangles, normalised; zero where it cancels.
/// Formulation 1, step 4.
void set_normals(DecisionTool& tool);

/// Moves every node to offset + scale x.
void place_at(DecisionTool& tool, double scale, const Vec3& offset);

}  // namespace type21
