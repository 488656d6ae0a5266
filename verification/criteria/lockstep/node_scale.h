/// @file The magnitudes that differences between two implementations are measured by.
#pragma once

#include "reference/contract/contact_step.h"
#include "reference/contract/interface.h"
#include "reference/contract/motion.h"

namespace type21 {

/// Magnitudes that enter the numbers of one node. A penetration is the small difference of coordinates and gap, a
/// relative velocity that of two velocities: both are accurate to a unit in the last place of the operands, not of the
/// difference.
struct NodeScale {
    double length = 0;     ///< largest tool-frame coordinate plus the gap; with D12 global ones, too [length]
    double force = 0;      ///< k (length) + |F| + (C + k dt) (velocities that are subtracted) [force]
    double stiffness = 0;  ///< k + C/dt [force/length]
    double heat = 0;       ///< see node_scale.cpp [energy]
    double speed = 0;      ///< |v| + |V| + |Omega| arm [velocity]
    double arm = 0;        ///< from x_G to the node, with the coordinates it is the difference of [length]
};

/// @param i     rank of the secondary node
/// @param node  the result of the reference for it
/// @param heat  likewise; zero where the interface exchanges none
/// @param d12   departure D12 is on
NodeScale node_scale(const Interface& card, size_t i, const NodeContact& node, const NodeHeat& heat,
                     const Motion& motion, bool d12);

}  // namespace type21
