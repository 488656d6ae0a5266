/// @file A scene to be timed: what is in it, and how it moves.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "reference/contract/motion.h"
#include "reference/model/host_scene.h"

namespace type21::bench {

struct BenchScene {
    std::string name, title;
    std::string kind;  ///< "common", "ties", "deck"
    HostScene scene;
    int interface = 0;
    double step_length = 0;  ///< way of the tool in a cycle [length]; 0: the deck's own motion
    int cycles = 0;          ///< of a recorded motion, 0: any number
    /// The motion of a cycle; its spans point into what the function owns, until the scene or the next call ends.
    std::function<Motion(int cycle)> motion;

    const Interface& card() const { return scene.model->interfaces[static_cast<size_t>(interface)]; }
    const std::vector<Segment>& segments() const {
        return scene.model->surfaces[static_cast<size_t>(card().main_surface)].segments;
    }
    size_t nodes() const { return card().secondary.node.size(); }
    size_t sub_triangles() const;
};

/// A blank of `blank` x `blank` quads, 110 x 110 mm, 1 mm thick, all nodes fixed; a tool of `tool` x `tool` quads, z =
/// 0.3 + r^2 / 40000 mm over 120 x 120 mm, that looks down on it and slides over it; gap 0.5 mm, Coulomb 0.1. 316 and
/// 220 are the sizes whose speed in OpenRadioss is known.
BenchScene bowl_bench(int blank = 316, int tool = 220);

/// A stamped pan, 2000 x 1400 mm, 80 mm deep with radii of about 50 mm and two beads, of about that many triangles that
/// are a little irregular; nodes lie anywhere within 1.9 mm of it, on both sides, in the order of the surface. Gap and
/// DEPTH are 2 mm, so that all of them are in contact; the tool moves 2 um a cycle.
/// @param gap  g and DEPTH [mm]
BenchScene pan_bench(const std::string& name, int triangles, int nodes, double gap = 2.0);

/// A flat mesh of squares of 8 mm, n a side, and a blank of squares of 4 mm right above it: every node lies over a
/// corner, the middle of an edge or a centre, and stays there while the tool moves 2 um a cycle along its normal.
/// Coordinates are dyadic, so that the ties are exact.
BenchScene ties_bench(int n);

/// Cycles after which a contact has set up what it sets up once (safe radii, exclusive regions).
constexpr int settling_cycles = 32;

/// The first cycles of a deck, as a run of it with the optimized contact moves.
/// @param cycles  at most; fewer where the run ends before
/// @throws std::runtime_error when the run stops before the third cycle
BenchScene deck_bench(const HostScene& scene, int interface, int cycles);

/// Whole numbers with the suffix k or M: "200k" is 200 000.
/// @throws std::invalid_argument for anything else, and for numbers outside [low, high]
int count_of(const std::string& word, int low, int high);
/// 200000 -> "200k"
std::string short_count(int count);

}  // namespace type21::bench
