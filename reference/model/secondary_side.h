/// @file The blank: its nodes and what each brings to the contact at time 0.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Fills nodes, thickness, contact thickness, area, element stiffness, mass and the shortest edge.
/// The secondary surface exists and has segments.  Formulation 2, step 1; Formulation 7, step 1.
void build_secondary_side(const CardValidator& validator);

/// Distinct nodes of the segments, ascending: index into Model::nodes.
std::vector<int> surface_nodes(const Surface& surface);

/// S of each node: mean of E t over all shells at the node, void ones included [force/length], 0 where there is none.
/// Formulation 7, step 1.
std::vector<double> element_stiffness(const Model& model, const std::vector<int>& nodes);

/// A of each node: a quarter of each quad (half of the cross product of its diagonals), a third of each triangle, of
/// the surface [length^2].  Formulation 7, step 3.
std::vector<double> nodal_area(const Model& model, const Surface& surface, const std::vector<int>& nodes);

/// Shortest side of the segments; sides between equal nodes do not count [length].
double shortest_edge(const Model& model, const Surface& surface);

}  // namespace type21
