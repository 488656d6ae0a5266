#include "reference/host/shell_conduction.h"

#include <array>
#include <cmath>

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

/// A thermal shell in this cycle.
struct ThermalShell {
    const Shell& shell;
    Gradients gradients;
    double strength = 0;  ///< k t A [power length^2 / temperature]
};

/// Calls use(thermal shell) for each.
template <class Use>
void each_thermal_shell(const Model& model, const HostState& state, Use&& use) {
    for (size_t s = 0; s < model.shells.size(); ++s) {
        const Shell& shell = model.shells[s];
        const Material& material =
            model.materials[static_cast<size_t>(model.parts[static_cast<size_t>(shell.part)].material)];
        if (!material.heat) continue;
        double mean = 0;
        for (size_t j = 0; j < static_cast<size_t>(shell.corners()); ++j)
            mean += state.temperature[static_cast<size_t>(shell.node[j])] / static_cast<double>(shell.corners());
        const double conductivity = material.heat->conductivity_a + material.heat->conductivity_b * mean;
        const double thickness = state.thickness.empty() ? shell.thickness : state.thickness[s];
        ThermalShell thermal{shell, gradients(shell, state.position), 0};
        thermal.strength = conductivity * thickness * thermal.gradients.area;
        use(thermal);
    }
}

bool has_heat(const Model& model, const HostState& state) {
    return !state.temperature.empty() && !model.nodal_heat_capacity.empty();
}

}  // namespace

std::vector<double> shell_conduction(const Model& model, const HostState& state, double step) {
    std::vector<double> heat;
    if (!has_heat(model, state)) return heat;
    heat.assign(state.temperature.size(), 0.0);
    each_thermal_shell(model, state, [&](const ThermalShell& thermal) {
        const auto& [shell, g, strength] = thermal;
        const auto corners = static_cast<size_t>(shell.corners());
        Vec3 slope = Vec3::Zero();
        for (size_t j = 0; j < corners; ++j)
            slope += g.b[j] * state.temperature[static_cast<size_t>(shell.node[j])];
        for (size_t j = 0; j < corners; ++j)
            heat[static_cast<size_t>(shell.node[j])] -= strength * g.b[j].dot(slope) * step;
    });
    return heat;
}

std::vector<double> shell_conductance(const Model& model, const HostState& state) {
    std::vector<double> conductance;
    if (!has_heat(model, state)) return conductance;
    conductance.assign(state.temperature.size(), 0.0);
    each_thermal_shell(model, state, [&](const ThermalShell& thermal) {
        const auto& [shell, g, strength] = thermal;
        const auto corners = static_cast<size_t>(shell.corners());
        for (size_t i = 0; i < corners; ++i)
            for (size_t j = 0; j < corners; ++j)
                conductance[static_cast<size_t>(shell.node[i])] += 0.5 * std::abs(strength * g.b[i].dot(g.b[j]));
    });
    return conductance;
}

}  // namespace type21
