/// @file Small scenes for hand calculations: a few free-standing nodes of unit area and mass over a small tool.
#pragma once

#include <vector>

#include "verification/support/scene_builder.h"

namespace type21::test {

/// A tool whose main node is in the origin, and nodes over it: gap 0.5, DEPTH 2, stiffness 1000. One second in steps of
/// a millisecond.
inline SceneBuilder small_scene(const SurfaceMesh& tool, const std::vector<Vec3>& blank) {
    return SceneBuilder().main_node(Vec3::Zero()).tool(tool).blank(blank).time_steps(1e-3, 1.0);
}

/// The tool is one quad of side 2 in the plane z = 0, normal +z, centred in the origin.
inline SceneBuilder over_a_square(const std::vector<Vec3>& blank) {
    return small_scene({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}}, blank);
}

}  // namespace type21::test
