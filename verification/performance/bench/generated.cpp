#include "verification/performance/bench/generated.h"

#include <numbers>

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
    constexpr double thickness = 1, young = 210, density = 7.8e-6;  // [mm], [GPa], [kg/mm^3]
    const double time = bench_step_length / parts.speed;            // of a cycle [ms]
    auto model = std::make_shared<Model>();
    model->surfaces.resize(2);
    const auto add_node = [&](const Vec3& x) {
        model->nodes.id.push_back(model->nodes.size() + 1);
        model->nodes.position.push_back(x);
        model->nodes.line.push_back(0);
    };
    for (const Vec3& x : parts.nodes)
        add_node(x);
    const int first = model->nodes.size();
    for (const Vec3& x : parts.tool)
        add_node(x);
    const auto add_segments = [&](Surface& surface, const std::vector<std::array<int, 4>>& segments, int first_node) {
        for (const auto& corners : segments) {
            Segment segment;
            for (size_t j = 0; j < 4; ++j)
                segment.node[j] = first_node + corners[j];
            surface.segments.push_back(segment);
        }
    };
    add_segments(model->surfaces[0], parts.blank, 0);
    add_segments(model->surfaces[1], parts.segments, first);
    RigidBody body;
    body.mass = 1;
    body.inertia = Mat3::Identity();
    model->rigid_bodies.push_back(body);

    Interface card;
    card.id = 1;
    card.secondary_surface = 0;
    card.main_surface = 1;
    card.tool = 0;
    card.istf.value = 1;
    card.stfac.value = 100;  // [kN/mm]
    card.viss.value = 1;
    card.fric.value = parts.friction ? 0.1 : 0.0;
    card.gapmax.value = card.tstop.value = card.pmax.value = card.pskid.value = card.stmax.value = 1e30;
    card.depth.value = card.largest_gap = parts.gap;
    card.shortest_edge = parts.edge;
    SecondarySide& side = card.secondary;
    for (int i = 0; i < first; ++i) {
        side.node.push_back(i);
        side.thickness.push_back(thickness);
        side.contact_thickness.push_back(0);
        side.gap.push_back(parts.gap);
        side.search_gap.push_back(parts.gap);
        side.area.push_back(parts.edge * parts.edge);
        side.element_stiffness.push_back(young * thickness);
        side.mass.push_back(density * parts.edge * parts.edge * thickness);
    }
    for (int i = first; i < model->nodes.size(); ++i)
        card.main_nodes.push_back(i);
    model->interfaces.push_back(card);

    BenchScene out;
    out.kind = "common";
    out.scene.effects = {{Effect::elastic, Effect::damping}};
    if (parts.friction) out.scene.effects[0].push_back(Effect::friction);
    out.scene.model = model;
    out.step_length = bench_step_length;
    auto velocity = std::make_shared<std::vector<Vec3>>(static_cast<size_t>(model->nodes.size()), Vec3::Zero());
    out.motion = [model, velocity, time, way = Vec3(parts.way.normalized())](int cycle) {
        Motion motion;
        motion.time = time * cycle;
        motion.step = motion.friction_step = cycle == 0 ? 0 : time;
        motion.position = model->nodes.position;
        motion.velocity = *velocity;
        ToolMotion tool;
        tool.position = way * (bench_step_length * cycle);
        tool.velocity = way * (bench_step_length / time);
        motion.tools = {tool};
        return motion;
    };
    return out;
}

}  // namespace type21::bench
