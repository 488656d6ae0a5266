/// @file A generated scene: a flat blank in full contact with a bowl that slides over it.
#pragma once

#include <vector>

#include "reference/host/motion.h"
#include "reference/model/scene.h"

namespace type21::bench {

/// A blank of `blank` x `blank` quads, 110 x 110 mm, 1 mm thick, all nodes fixed; a tool of `tool` x `tool` quads, z =
/// 0.3 + r^2 / 40000 mm over 120 x 120 mm, that looks down on it; gap 0.5 mm, Coulomb 0.1. 316 and 220 are the sizes
/// whose speed in OpenRadioss is known.
struct BowlScene {
    BowlScene(int blank, int tool, bool friction = true);

    /// The tool after `cycle` steps of 2 um along (1, 0, -1); the spans point into this.
    Motion motion(int cycle);

    Scene scene;
    std::vector<Vec3> velocity;
};

}  // namespace type21::bench
