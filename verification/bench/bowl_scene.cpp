#include "verification/bench/bowl_scene.h"

#include <numbers>

namespace type21::bench {

namespace {

constexpr double blank_size = 110, tool_size = 120, thickness = 1, gap = 0.5;  // [mm]
constexpr double young = 210, density = 7.8e-6;                                // [GPa], [kg/mm^3]
constexpr double way = 0.002, step = 0.002 / (0.1 * std::numbers::sqrt2);      // [mm], [ms]: 100 mm/s in x and in -z

void grid(int n, double size, Model& model, Surface& surface, bool downward, double (*height)(double, double)) {
    const int first = model.nodes.size();
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double x = size * (double(i) / n - 0.5), y = size * (double(j) / n - 0.5);
            model.nodes.id.push_back(model.nodes.size() + 1);
            model.nodes.position.emplace_back(x, y, height(x, y));
            model.nodes.line.push_back(0);
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = first + j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            Segment segment;
            segment.node = downward ? std::array<int, 4>{a, d, c, b} : std::array<int, 4>{a, b, c, d};
            surface.segments.push_back(segment);
        }
    }
}

}  // namespace

BowlScene::BowlScene(int blank, int tool, bool friction) {
    auto model = std::make_shared<Model>();
    model->surfaces.resize(2);
    grid(blank, blank_size, *model, model->surfaces[0], false, [](double, double) { return 0.0; });
    const int nodes = model->nodes.size();
    grid(tool, tool_size, *model, model->surfaces[1], true,
         [](double x, double y) { return 0.3 + (x * x + y * y) / 40000; });
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
    card.fric.value = friction ? 0.1 : 0.0;
    card.gapmax.value = card.tstop.value = card.pmax.value = card.pskid.value = card.stmax.value = 1e30;
    card.depth.value = gap;
    card.largest_gap = gap;
    const double edge = blank_size / blank;
    SecondarySide& side = card.secondary;
    for (int i = 0; i < nodes; ++i) {
        side.node.push_back(i);
        side.thickness.push_back(thickness);
        side.contact_thickness.push_back(0);
        side.gap.push_back(gap);
        side.search_gap.push_back(gap);
        side.area.push_back(edge * edge);
        side.element_stiffness.push_back(young * thickness);
        side.mass.push_back(density * edge * edge * thickness);
    }
    for (int i = nodes; i < model->nodes.size(); ++i)
        card.main_nodes.push_back(i);
    card.shortest_edge = edge;
    model->interfaces.push_back(card);
    velocity.assign(static_cast<size_t>(model->nodes.size()), Vec3::Zero());
    scene.effects = {{Effect::elastic, Effect::damping}};
    if (friction) scene.effects[0].push_back(Effect::friction);
    scene.model = std::move(model);
}

Motion BowlScene::motion(int cycle) {
    Motion motion;
    motion.time = step * cycle;
    motion.step = motion.friction_step = cycle == 0 ? 0 : step;
    motion.position = scene.model->nodes.position;
    motion.velocity = velocity;
    ToolMotion tool;
    const Vec3 direction = Vec3(1, 0, -1) / std::numbers::sqrt2;
    tool.position = direction * (way * cycle);
    tool.velocity = direction * (way / step);
    motion.tools = {tool};
    return motion;
}

}  // namespace type21::bench
