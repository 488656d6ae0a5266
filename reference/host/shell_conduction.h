/// @file Heat that flows inside the shells of thermal materials, between contact and the next temperature.
#pragma once

#include <vector>

#include "reference/host/state.h"

namespace type21 {

/// Heat of one cycle from Fourier's law with one integration point a shell:
///   grad T = sum B_i T_i,   heat to node i = -k(T) t A <B_i, grad T> dt,   k = A_S + B_S T at the shell's mean
///   temperature
/// with B_1 = -n x (x_2 - x_4) / (2A), B_2 = -n x (x_3 - x_1) / (2A), B_3 = -B_1, B_4 = -B_2 of a quad and
/// B_1 = -n x (x_2 - x_3) / (2A), cyclic, of a triangle. What one node loses another gains.
/// The manual page leaves the inside of the blank to the elements; the formula is the measured one (cases
/// therm_cond_2x2, therm_form1).  Formulation 11, step 6.
/// @param step  dt1 [time]
/// @return heat to each node [energy]; empty where no shell is thermal
std::vector<double> shell_conduction(const Model& model, const HostState& state, double step);

/// Conductance of the inside of the shells at each node, for the thermal step: half of the sum of |K_ij| over all nodes
/// j, K_ij = k t A <B_i, B_j>. Heat flows from node to node like through conductors whose sum is at most this.
/// Formulation 11, step 3.
/// @return [power/temperature]; empty where no shell is thermal
std::vector<double> shell_conductance(const Model& model, const HostState& state);

}  // namespace type21
