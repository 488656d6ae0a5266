#include "reference/host/shell_conduction.h"

#include <array>

namespace type21 {

namespace {

/// Gradients of the shape functions at the shell's one point.
struct Gradients {
    std::array<Vec3, 4> b;
    double area = 0;  ///< [length^2]
};

Gradients gradients(const Shell& shell, const std::vector<Vec3>& position) {
    const auto x = [&](size_t j) -> const Vec3& { return position[static_cast<size_t>(shell.node[j])]; };
    Gradients g;
    g.b.fill(Vec3::Zero());
    const Vec3 twice =
        shell.is_triangle() ? Vec3((x(1) - x(0)).cross(x(2) - x(0))) : Vec3((x(2) - x(0)).cross(x(3) - x(1)));
    const double size = twice.norm();
    if (size == 0) return g;
    const Vec3 normal = twice / size;
    g.area = 0.5 * size;
    const auto across = [&](const Vec3& side) { return Vec3(side.cross(normal) / size); };
    if (shell.is_triangle()) {
        for (size_t j = 0; j < 3; ++j)
            g.b[j] = across(x((j + 1) % 3) - x((j + 2) % 3));
    } else {
        g.b[0] = across(x(1) - x(3));
        g.b[1] = across(x(2) - x(0));
        g.b[2] = -g.b[0];
        g.b[3] = -g.b[1];
    }
    return g;
}

}  // namespace

std::vector<double> shell_conduction(const Model& model, const HostState& state, double step) {
    std::vector<double> heat;
    if (state.temperature.empty() || model.nodal_heat_capacity.empty()) return heat;
    heat.assign(state.temperature.size(), 0.0);
    for (size_t s = 0; s < model.shells.size(); ++s) {
        const Shell& shell = model.shells[s];
        const Material& material =
            model.materials[static_cast<size_t>(model.parts[static_cast<size_t>(shell.part)].material)];
        if (!material.heat) continue;
        const Gradients g = gradients(shell, state.position);
        const auto corners = static_cast<size_t>(shell.corners());
        Vec3 slope = Vec3::Zero();
        double mean = 0;
        for (size_t j = 0; j < corners; ++j) {
            const double temperature = state.temperature[static_cast<size_t>(shell.node[j])];
            slope += g.b[j] * temperature;
            mean += temperature / static_cast<double>(corners);
        }
        const double thickness = state.thickness.empty() ? shell.thickness : state.thickness[s];
        const double conductivity = material.heat->conductivity_a + material.heat->conductivity_b * mean;
        for (size_t j = 0; j < corners; ++j) {
            heat[static_cast<size_t>(shell.node[j])] -= conductivity * thickness * g.area * g.b[j].dot(slope) * step;
        }
    }
    return heat;
}

}  // namespace type21
