/// @file D34: the box in which a node must lie before a segment competes for it at all.
#pragma once

#include "reference/contact/tool_surface.h"

namespace type21::reference::as_built {

/// As documented: every segment competes for a node.
/// As built: only one whose box holds the node. The box spans x_j + reach n_j and x_j - DEPTH n_j over the corners j
/// and is grown by 1 % of its size on each side. Contact is lost over narrow convex strips.
/// @param y      the node in the tool frame [length]
/// @param axes   columns: the axes of the box, in the tool frame
/// @param reach  larger of the gap that decides contact and the reach of heat [length]
/// @param depth  DEPTH [length].  Formulation 12, step 2; Formulation 4, step 1.
/// @manual departure D34
bool in_reach_box(const Vec3& y, const SegmentShape<double>& segment, const Mat3& axes, double reach, double depth);

/// Axes of the box: the principal axes of the tool when it can turn, else the global axes.
/// @return columns, in the tool frame [-]
Mat3 reach_box_axes(const RigidBody& tool, bool tool_rotates);

}  // namespace type21::reference::as_built
