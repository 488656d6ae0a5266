/// @file One question, one answer: a node against all segments of a small tool.
#pragma once

#include <array>
#include <vector>

#include "reference/contract/decision.h"
#include "reference/contract/vector.h"

namespace type21::optimized {

/// Tests the input of decide_query.
/// @throws std::invalid_argument where a number is not finite or an index is out of range
void check_query(const std::vector<Vec3>& nodes, const std::vector<Vec3>& normals,
                 const std::vector<std::array<int, 4>>& segments, const Vec3& p, double gap, double depth,
                 double reach);

/// The retained impact of a node, exact in the sense of Formulation 10, step 1: the one that real arithmetic on
/// the given doubles would give.
/// @param nodes     positions in the tool frame [length]
/// @param normals   of each node, taken as given [-]
/// @param segments  indices into nodes; a triangle repeats its third
/// @param p         the node [length]
/// @param gap, depth, reach  g, DEPTH and the reach of proximity (0: none) [length]
/// @throws std::invalid_argument as check_query
Decision decide_query(const std::vector<Vec3>& nodes, const std::vector<Vec3>& normals,
                      const std::vector<std::array<int, 4>>& segments, const Vec3& p, double gap, double depth,
                      double reach);

}  // namespace type21::optimized
