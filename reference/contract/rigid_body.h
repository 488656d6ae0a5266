/// @file The rigid body that carries a tool (/RBODY).
#pragma once

#include <string>
#include <vector>

#include "mesh.h"

namespace type21 {

/// /RBODY: its nodes move as one about the main node.
struct RigidBody {
    Id id = 0;
    std::string title;
    int main_node = -1;
    std::vector<int> nodes;       ///< secondary nodes of the body, ascending, without the main node
    double mass = 0;              ///< of the whole body, by its ICoG rule [mass]
    Mat3 inertia = Mat3::Zero();  ///< about the centre, global axes at time 0 [mass length^2]
    Vec3 center = Vec3::Zero();   ///< position of the main node after ICoG has moved it [length]
    int icog = 1;
    bool spherical = false;  ///< Ispher
};

/// Smallest principal inertia of a body. It does not change when the body turns.
/// @param inertia  about the centre, any axes [mass length^2]
double smallest_inertia(const Mat3& inertia);

/// Inertia about an axis through the centre: <u, I u> with the unit vector u along it.
/// @param inertia  about the centre [mass length^2]
/// @param axis     any length, in the axes of the inertia; the zero vector is no axis, and gives 0
double inertia_about(const Mat3& inertia, const Vec3& axis);

}  // namespace type21
