/// @file D34: the box within which a node must lie before a segment competes for it at all.
#pragma once

#include "reference/contact/tool_surface.h"

namespace type21::reference {

/// The page lets all segments compete. As built a node must lie in the box of x_j + reach n_j and x_j - DEPTH n_j over
/// the corners j, grown by 1 % of its size on each side: contact is lost over narrow convex strips.
/// @param axes   columns: principal axes of the tool when it can turn, else the global axes, in the tool frame
/// @param reach  largest of the gap that decides contact and the proximity reach [length]
/// @manual departure D34
bool in_reach_box(const Vec3& y, const SegmentShape<double>& segment, const Mat3& axes, double reach, double depth);

/// Axes of the box for this tool.
Mat3 reach_box_axes(const RigidBody& tool, bool tool_rotates);

}  // namespace type21::reference
