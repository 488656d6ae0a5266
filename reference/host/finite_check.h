/// @file Every number that a run hands on is finite, or the run stops (Formulation 11, step 11).
#pragma once

#include <vector>

#include "reference/contract/contact_step.h"
#include "reference/deck/problem.h"
#include "reference/host/march.h"
#include "reference/host/state.h"

namespace type21 {

/// Numbers beyond this count as infinite: what is computed from them next (products of two or three) would overflow.
inline constexpr double largest_number = 1e100;

/// Nodes, tools and contacts of cycle n.
/// @throws RunStopped naming quantity, node (or interface, tool), cycle and time
void check_finite(const Model& model, const HostState& state, const std::vector<ContactStep>& steps);

/// What the record of cycle n holds beside them: sums, accelerations, reactions, temperatures at its end.
/// @param state  of cycle n
/// @param next   behind it
/// @throws RunStopped likewise
void check_finite(const Model& model, const HostState& state, const HostState& next,
                  const std::vector<InterfaceTotals>& totals);

/// Masses, heat capacities, stiffnesses and areas that the deck gives: an error names the node or the tool.
void check_finite(const Model& model, Problems& problems);

}  // namespace type21
