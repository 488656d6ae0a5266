#include "verification/performance/accuracy/effect_scene.h"

#include "verification/stability/bench_scene.h"

namespace type21::accuracy {

namespace {

constexpr double radius = 200;   // of the tool [mm]
constexpr double inside = 0.1;   // penetration without thickening [mm]
constexpr double pitch = 1.1;    // of the tool; that of the sheet is 0.7 [mm]
constexpr double fine = 0.7;     // [mm]
constexpr double way = 0.002;    // of the tool in a cycle [mm]
constexpr double step = 1e-6;    // [s]
constexpr double growth = 1.02;  // of the thickness [-]

double height(double x, double y) {
    return (x * x + y * y) / (2 * radius);
}

stability::Tool tool(int nodes) {
    const int side = static_cast<int>(fine * nodes / pitch) + 4;
    stability::Tool tool;
    for (int j = 0; j <= side; ++j)
        for (int i = 0; i <= side; ++i) {
            const double x = pitch * (i - 0.5 * side), y = pitch * (j - 0.5 * side);
            tool.node.emplace_back(x, y, height(x, y));
        }
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const int first = j * (side + 1) + i;
            tool.segment.push_back({first, first + 1, first + side + 2, first + side + 1});
        }
    return tool;
}

std::vector<Vec3> sheet(int nodes) {
    std::vector<Vec3> at;
    for (int j = 0; j < nodes; ++j)
        for (int i = 0; i < nodes; ++i) {
            // Not centred on the tool: ties would hide what an effect costs.
            const double x = fine * (i - 0.5 * (nodes - 1)) + 0.0719, y = fine * (j - 0.5 * (nodes - 1)) + 0.1437;
            at.emplace_back(x, y, height(x, y) + stability::gap - inside);
        }
    return at;
}

}  // namespace

EffectScene::EffectScene(int nodes) {
    Model model = *stability::BenchScene(tool(nodes), sheet(nodes)).scene().host;
    Material steel;
    steel.id = 1;
    steel.law = MaterialLaw::elastic;
    steel.heat = HeatMaterial{300, 3.6, 40, 0};  // [K], [mJ/(mm3 K)], [mW/(mm K)]
    model.materials = {steel};
    model.properties.resize(1);
    Part part;
    part.property = part.material = 0;
    model.parts = {part};
    Interface& card = model.interfaces[0];
    SecondarySide& side = card.secondary;
    side.thickness.assign(side.node.size(), 2 * stability::gap);
    for (int j = 0; j + 1 < nodes; ++j)
        for (int i = 0; i + 1 < nodes; ++i) {
            const auto at = [&](int column, int row) {
                return side.node[static_cast<size_t>(row) * static_cast<size_t>(nodes) + static_cast<size_t>(column)];
            };
            Shell shell;
            shell.id = static_cast<Id>(model.shells.size()) + 1;
            shell.node = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
            shell.part = 0;
            shell.thickness = 2 * stability::gap;
            Segment segment;
            segment.node = shell.node;
            segment.shell = static_cast<int>(model.shells.size());
            model.surfaces[1].segments.push_back(segment);
            model.shells.push_back(shell);
        }
    card.fscalegap.value = 1;
    velocity_.assign(model.nodes.position.size(), Vec3::Zero());
    temperature_.assign(model.nodes.position.size(), 300);
    thickness_.assign(model.shells.size(), growth * 2 * stability::gap);
    scene_ = plan(std::make_shared<const Model>(std::move(model)));
}

Motion EffectScene::motion(int cycle) const {
    Motion motion;
    motion.time = step * cycle;
    motion.step = motion.friction_step = cycle == 0 ? 0 : step;
    motion.position = scene_.model->nodes.position;
    motion.velocity = velocity_;
    motion.thickness = thickness_;
    motion.temperature = temperature_;
    ToolMotion pose;
    pose.position = Vec3(way * cycle, 0, 0);
    pose.velocity = Vec3(way / step, 0, 0);
    motion.tools = {pose};
    return motion;
}

}  // namespace type21::accuracy
