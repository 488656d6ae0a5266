#include "verification/performance/bench/generated.h"

#include <memory>

#include "verification/support/prescribed_motion.h"
#include "verification/support/scene_builder.h"

namespace type21::bench {

double noise(std::uint64_t a, std::uint64_t b) {
    // splitmix64 of both.
    std::uint64_t z = a * 0x9E3779B97F4A7C15U + (b + 1) * 0xD1B54A32D192ED03U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) * 0x1p-52 - 1;
}

BenchScene generated(const GeneratedParts& parts) {
    constexpr double thickness = 1, young = 210, density = 7.8e-6;      // [mm], [GPa], [kg/mm^3]
    const double time = bench_step_length / parts.speed;                // of a cycle [ms]
    const double mass = density * parts.edge * parts.edge * thickness;  // of a node [kg]
    SceneBuilder builder;
    builder.blank(parts.nodes, {parts.gap, parts.edge * parts.edge, young * thickness, mass, thickness}, 1)
        .blank_segments(parts.blank)
        .tool({parts.tool, parts.segments}, 1)
        .depth(parts.gap)
        .viss(1)
        .fric(parts.friction ? 0.1 : 0.0)
        .card([&](Interface& card) {
            card.istf.value = 1;
            card.stfac.value = 100;  // [kN/mm]
            card.shortest_edge = parts.edge;
        });

    BenchScene out;
    out.kind = "common";
    out.scene = builder.scene();
    out.step_length = bench_step_length;
    const auto tool = std::make_shared<SlidingTool>(out.scene.model, parts.way.normalized(), bench_step_length, time);
    out.motion = [tool](int cycle) { return tool->at(cycle); };
    return out;
}

}  // namespace type21::bench
