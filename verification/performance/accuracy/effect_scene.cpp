#include "verification/performance/accuracy/effect_scene.h"

namespace type21::accuracy {

namespace {

constexpr double gap = 1.0;                 // g of every node [mm]
constexpr double nodal_stiffness = 1000.0;  // Stfac with Istf 1 [N/mm]
constexpr double radius = 200;              // of the tool [mm]
constexpr double inside = 0.1;              // penetration without thickening [mm]
constexpr double pitch = 1.1;               // of the tool; that of the sheet is 0.7 [mm]
constexpr double fine = 0.7;                // [mm]
constexpr double travel = 0.002;            // of the tool in a cycle [mm]
constexpr double step = 1e-6;               // [s]
constexpr double growth = 1.02;             // of the thickness [-]

double height(double x, double y) {
    return (x * x + y * y) / (2 * radius);
}

SurfaceMesh curved_tool(int nodes) {
    const int side = static_cast<int>(fine * nodes / pitch) + 4;
    return grid(side, side, [&](int i, int j) {
        const double x = pitch * (i - 0.5 * side), y = pitch * (j - 0.5 * side);
        return Vec3(x, y, height(x, y));
    });
}

SurfaceMesh sheet(int nodes) {
    return grid(nodes - 1, nodes - 1, [&](int i, int j) {
        // Not centred on the tool: ties would hide what an effect costs.
        const double x = fine * (i - 0.5 * (nodes - 1)) + 0.0719, y = fine * (j - 0.5 * (nodes - 1)) + 0.1437;
        return Vec3(x, y, height(x, y) + gap - inside);
    });
}

Material thermal_steel() {
    Material steel;
    steel.id = 1;
    steel.law = MaterialLaw::elastic;
    steel.heat = HeatMaterial{300, 3.6, 40, 0};  // [K], [mJ/(mm3 K)], [mW/(mm K)]
    return steel;
}

HostScene scene_of(int nodes, const std::function<void(Interface& card)>& change) {
    const SurfaceMesh blank = sheet(nodes);
    return SceneBuilder()
        .main_node(Vec3::Zero())
        .tool(curved_tool(nodes))
        .blank(blank.node, {gap, 1, nodal_stiffness, 1, 2 * gap})
        .blank_shells(blank.segment, 2 * gap, thermal_steel())
        .card([](Interface& card) {
            card.istf.value = 1;
            card.stfac.value = nodal_stiffness;
            card.fscalegap.value = 1;
        })
        .card(change)
        .scene();
}

}  // namespace

EffectScene::EffectScene(int nodes, const std::function<void(Interface& card)>& change)
    : scene_(scene_of(nodes, change)),
      tool_(scene_.model, Vec3::UnitX(), travel, step),
      thickness_(scene_.model->shells.size(), growth * 2 * gap),
      temperature_(static_cast<size_t>(scene_.model->nodes.size()), 300) {}

Motion EffectScene::motion(int cycle) const {
    Motion motion = tool_.at(cycle);
    motion.thickness = thickness_;
    motion.temperature = temperature_;
    return motion;
}

}  // namespace type21::accuracy
