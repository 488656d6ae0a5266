/// @file The force of one node again, from the laws of the reference and the history before the cycle: what a
/// ContactStep does not carry (trial force, limits, factors), and a check of what it does.
#pragma once

#include "reference/contact/friction_increment.h"
#include "reference/contract/contact_step.h"
#include "reference/cycle/inspect.h"
#include "reference/model/model.h"

namespace type21 {

/// What a node remembered before the cycle.
struct NodeBefore {
    reference::PenetrationHistory penetration;
    Vec3 friction = Vec3::Zero();  ///< F_t of the cycle before [force]
};

struct Replay {
    bool impact = false;         ///< p_g > 0 or retained at time 0: chapters 6 to 8 of the formulation apply
    int cycles = 0;              ///< consecutive cycles of this impact, this one included
    double offset_before = 0;    ///< P0 as this cycle begins with it [length]
    double offset = 0;           ///< P0 [length]
    double penetration = 0;      ///< p [length]
    bool acts = false;           ///< the stiffness acts
    double stiffness = 0;        ///< k [force/length]
    double damping = 0;          ///< C [force time/length]
    double normal_velocity = 0;  ///< v_n [velocity]
    double elastic_force = 0;    ///< F [force]
    double normal_force = 0;     ///< F_n [force]
    bool limited = false;        ///< the plateau of Pmax acts
    reference::PmaxLimit pmax;
    // friction
    bool has_friction = false;
    reference::FrictionInput input;
    double coefficient = 0;  ///< mu [-]
    double filter = 1;       ///< alpha [-]
    double limit = 0;        ///< smaller of mu |F_n| and the cap [force]
    reference::FrictionForce friction;
    double slip_energy = 0;     ///< q [energy]
    Vec3 force = Vec3::Zero();  ///< on the node [force]
};

/// @param node    what the ContactStep says of secondary node i in this cycle
/// @param before  its history as the cycle began, that of Inacti included
Replay replay(const Interface& interface, const reference::Inspect& inspect, int i, const Motion& motion,
              const NodeContact& node, const NodeBefore& before);

}  // namespace type21
