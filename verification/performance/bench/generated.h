/// @file What generated scenes have in common: a fixed blank, a rigid tool that slides, one card.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "verification/performance/bench/bench_scene.h"

namespace type21::bench {

struct GeneratedParts {
    std::vector<Vec3> tool;                    ///< nodes of the tool [mm]
    std::vector<std::array<int, 4>> segments;  ///< into tool
    std::vector<Vec3> nodes;                   ///< secondary nodes [mm]
    std::vector<std::array<int, 4>> blank;     ///< segments of the blank, into nodes; may be empty
    double edge = 1;                           ///< of the blank: its area, mass, and DEPTH's least [mm]
    double gap = 0.5;                          ///< g and DEPTH [mm]
    Vec3 way = Vec3(0, 0, -1);                 ///< direction in which the tool moves
    double speed = 0.1;                        ///< [mm/ms]
    bool friction = true;
};

/// 2 um a cycle.
inline constexpr double bench_step_length = 0.002;

/// Fills scene and motion; units kg mm ms, penalty 100 kN/mm, VISs 1, Coulomb 0.1.
BenchScene generated(const GeneratedParts& parts);

/// Deterministic noise in [-1, 1).
double noise(std::uint64_t a, std::uint64_t b);

}  // namespace type21::bench
