/// @file Thickness and gap of each node at time 0, Gapmin's and DEPTH's defaults.
#pragma once

#include <string>
#include <vector>

#include "reference/model/card_validator.h"

namespace type21 {

/// t0 of each node of the interface: the largest thickness of the shells at it, those of void material left out.
/// @param nodes  index into Model::nodes, ascending
/// @return [length], one for each of nodes, 0 where there is no such shell.  Formulation 2, step 1.
std::vector<double> nodal_thickness(const Model& model, const std::vector<int>& nodes);

/// Whether each node of the model has shells, and void ones alone: they have no thickness for a contact.
std::vector<bool> nodes_of_void_shells(const Model& model);

/// t_c of each node: the largest contact thickness (Thick of /PART) of the secondary elements at it, 0 = none.
/// @param nodes  index into Model::nodes, ascending
/// @return [length], one for each of nodes.  Formulation 2, step 2; as built: D29.
std::vector<double> contact_thickness(const Model& model, const Surface& secondary, const std::vector<int>& nodes);

/// Contact thickness (Thick of /PART) of the part of a segment's element, 0 without an element [length].
double part_thickness(const Model& model, const Segment& segment);

/// Default of Gapmin with Igap 0, and its reason for the user.
struct GapminDefault {
    double value = 0;  ///< [length]
    std::string why;
};

/// Half of the mean thickness of the secondary shells.  Formulation 2, step 3; as built: D19.
GapminDefault gapmin_default(const CardValidator& validator);

/// Gap that decides contact: the node's own.
/// @param raw  g_s [length]
/// @param gap  g0 [length]
/// @return [length].  Formulation 2, step 7; as built: D33.
double own_search_gap(const Interface& interface, double raw, double gap);

/// Mean, taken up one value at a time, so that the mean of equal values is that value to the last bit; 0 for none.
double mean(const std::vector<double>& values);

/// Fills gap, search_gap, largest_gap, smallest_gap_raw and resolves Gapmin and DEPTH; needs thickness,
/// contact_thickness and shortest_edge.
///   Igap 0: g0 = Gapmin, 0 -> half of the mean thickness of the secondary shells
///   Igap 1, 2: g0 = max(Gapmin, min(g_s, Gapmax)),  g_s = 1/2 Fscalegap (t_c or else t0)
///   DEPTH:  0 -> max(largest g0, shortest edge), else at least the largest g0
/// Formulation 2, step 3 to step 8; manual page, comments 2 and 4, equations (1) to (4) at time 0; as built: D19, D33.
void resolve_gaps(const CardValidator& validator);

}  // namespace type21
