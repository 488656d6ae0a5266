#include "optimized/kernel/heat_law.h"

#include <algorithm>
#include <cmath>

namespace type21::optimized {

namespace {

/// Two resistances in series, per area: d / k_s of the sheet or the gap, 1 / K of the surfaces. Nothing flows without
/// K, nor over a distance without conductivity.
double in_series(double exchange, double distance, double conductivity) {
    if (!(exchange > 0)) return 0;
    if (!(distance > 0)) return exchange;
    return conductivity > 0 ? 1 / (distance / conductivity + 1 / exchange) : 0.0;
}

}  // namespace

HeatLaw::HeatLaw(const ContactModel& model, const Interface& interface)
    : card_(interface),
      area_(interface.secondary.area),
      nodal_tool_(interface.ithe == 2 || interface.ithe_form == 1),
      heats_tool_(interface.ithe_form == 1),
      d15_(model.as_built.has(Departure::D15)),
      d32_(model.as_built.has(Departure::D32)),
      d38_(model.as_built.has(Departure::D38)),
      conductivity_(static_cast<size_t>(interface.secondary.size())) {
    const auto function = [&](int index) { return index < 0 ? nullptr : &model.functions[static_cast<size_t>(index)]; };
    of_pressure_ = function(interface.function_conduction);
    of_distance_ = function(interface.function_distance);
    const auto& nodes = interface.secondary.node;
    std::vector<double> weight(conductivity_.size(), 0.0);
    for (const Shell& shell : model.shells) {
        const auto& part = model.parts[static_cast<size_t>(shell.part)];
        const auto& heat = model.materials[static_cast<size_t>(part.material)].heat;
        if (!heat) continue;
        const auto x = [&](size_t j) -> const Vec3& {
            return model.nodes.position[static_cast<size_t>(shell.node[j])];
        };
        const double share = shell.is_triangle() ? (0.5 * (x(1) - x(0)).cross(x(2) - x(0)).norm()) / 3
                                                 : (0.5 * (x(2) - x(0)).cross(x(3) - x(1)).norm()) / 4;
        for (int j = 0; j < shell.corners(); ++j) {
            const int node = shell.node[static_cast<size_t>(j)];
            const auto rank = std::lower_bound(nodes.begin(), nodes.end(), node);
            if (rank == nodes.end() || *rank != node) continue;
            const auto i = static_cast<size_t>(rank - nodes.begin());
            conductivity_[i].a += share * heat->conductivity_a;
            conductivity_[i].b += share * heat->conductivity_b;
            weight[i] += share;
        }
    }
    for (size_t i = 0; i < weight.size(); ++i) {
        if (weight[i] > 0) conductivity_[i] = {conductivity_[i].a / weight[i], conductivity_[i].b / weight[i]};
    }
}

double HeatLaw::exchange(double pressure) const {
    if (of_pressure_ == nullptr) return card_.kthe;
    return card_.kthe * (*of_pressure_)(d38_ ? card_.ascalek * pressure : pressure / card_.ascalek);
}

Heat HeatLaw::operator()(int node, double distance, double gap, double force, double blank, double tool,
                         double step) const {
    const auto i = static_cast<size_t>(node);
    const double area = area_[i];
    const double d = std::max(distance, 0.0);
    const double conductivity = conductivity_[i].a + conductivity_[i].b * blank;
    Heat heat;
    if (d <= gap) {
        const double pressure = area > 0 ? std::abs(force) / area : 0.0;
        heat.conductance = area * in_series(exchange(pressure), d, conductivity);
    } else {
        if (of_distance_ != nullptr && d <= card_.dcond) {
            const double share = (*of_distance_)((d - gap) / (card_.dcond - gap));
            heat.conductance = area * (d32_ ? share * in_series(exchange(0), gap, conductivity)
                                            : in_series(exchange(0) * share, gap, conductivity));
        }
        if (card_.frad > 0 && (d15_ ? d - gap : d) <= card_.drad) {
            // T_m^4 - T_s^4 as a product: no two large powers cancel.
            heat.radiant = area * (card_.frad * (tool * tool + blank * blank) * (tool + blank));
        }
    }
    heat.to_node = (heat.conductance + heat.radiant) * (tool - blank) * step;
    return heat;
}

}  // namespace type21::optimized
