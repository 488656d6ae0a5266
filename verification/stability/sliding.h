/// @file Sliding continuity: the part of the force's jump from one step to the next that does not vanish with the step.
#pragma once

#include <array>
#include <vector>

#include "reference/host/march.h"
#include "verification/stability/tool_shapes.h"

namespace type21::stability {

inline constexpr int path_steps = 5;        ///< the first and four halvings
inline constexpr double first_step = 0.02;  ///< travel in a cycle on the coarsest path [mm]
inline constexpr double path_depth = 0.3;   ///< penetration over the smooth tool [mm]
inline constexpr double path_friction = 0.2;

/// Largest |F_{n+1} - F_n| on the path, for each travel per cycle.
struct Jumps {
    std::array<double, path_steps> largest{};  ///< [N]

    /// The part that does not halve: J(h) = J0 + c h through the two finest paths, not below 0 [N].
    double residual() const;
};

struct SlidingRow {
    Shape shape{};
    Mesh mesh{};
    double mean_force = 0;  ///< |F_n nu| on the finest path [N]
    Jumps normal, friction;
    Jumps facet_normal, facet_friction;  ///< the same path over plain facet normals
    int open = 0;                        ///< cycles out of contact
};

/// A node is moved at constant depth over every tool and mesh, obliquely, over some ten elements' borders.
std::vector<SlidingRow> slide_over_all(const MakeContact& make_contact);
SlidingRow slide_over(const MakeContact& make_contact, Shape shape, Mesh mesh);

}  // namespace type21::stability
