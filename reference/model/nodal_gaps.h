/// @file Thickness and gap of each node at time 0, Gapmin's and DEPTH's defaults.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// t0 of each node of the interface: the largest thickness of the shells at it, those of void material left out.
/// @return [length], like SecondarySide::node, 0 where there is no such shell.  Source: formulation 2
std::vector<double> nodal_thickness(const Model& model, const std::vector<int>& nodes);

/// t_c of each node: the largest contact thickness (Thick of /PART) of the secondary elements at it, 0 = none; with D29
/// as built.
/// @return [length], like SecondarySide::node.  Source: page, comment 2; formulation 2, 12 (D29)
std::vector<double> contact_thickness(const Model& model, const Surface& secondary, const std::vector<int>& nodes);

/// Fills gap, search_gap, largest_gap, smallest_gap_raw and resolves Gapmin and DEPTH; needs thickness,
/// contact_thickness and shortest_edge.
///   Igap 0: g0 = Gapmin, 0 -> half of the mean thickness of the secondary shells
///   Igap 1, 2: g0 = max(Gapmin, min(g_s, Gapmax)),  g_s = 1/2 Fscalegap (t_c or else t0)
///   DEPTH:  0 -> max(largest g0, shortest edge), else at least the largest g0
/// Source: page, equations (1) to (4) at time 0, comments 2 and 4; formulation 2, 12 (D19, D33)
void resolve_gaps(const CardValidator& judge);

}  // namespace type21
