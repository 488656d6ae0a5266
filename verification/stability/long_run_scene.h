/// @file What the scenes of the long runs have in common: a tool and a few nodes of unit mass. Mg, mm, s.
#pragma once

#include <vector>

#include "verification/stability/tool_shapes.h"
#include "verification/support/scene_builder.h"

namespace type21::stability {

inline constexpr double stiffness = 1000.0;  ///< k of every node, Istf 1 [N/mm]
inline constexpr double node_mass = 1.0;     ///< m of every node [Mg]
inline constexpr double gap = 1.0;           ///< g, Igap 0 [mm]
inline constexpr double depth = 2.0;         ///< DEPTH [mm]

/// Nodes over a tool whose main node is held in the origin. VISs 0 and Fric 0 until the caller sets them.
inline SceneBuilder long_run_scene(const SurfaceMesh& tool, const std::vector<Vec3>& blank) {
    SceneBuilder builder;
    builder.units({1000.0, 0.001, 1.0, "Mg", "mm", "s"})
        .main_node(Vec3::Zero())
        .tool(tool)
        .blank(blank, {gap, 1, stiffness, node_mass})
        .depth(depth)
        .card([](Interface& card) {
            card.istf.value = 1;
            card.stfac.value = stiffness;
        })
        .hold(builder.main_node());
    return builder;
}

/// A constant time step [s], and an end that gives this many cycles.
inline void set_cycles(SceneBuilder& builder, double step, long cycles) {
    builder.time_steps(step, (static_cast<double>(cycles) - 0.5) * step);
}

}  // namespace type21::stability
