#include "reference/contact/heat_exchange.h"

#include <algorithm>
#include <cmath>

namespace type21::reference {

HeatExchange::HeatExchange(const ContactModel& model, const Interface& interface, const ContactReading& reading)
    : model_(model),
      interface_(interface),
      reading_(reading),
      conductivity_(static_cast<size_t>(interface.secondary.size())) {
    const auto& nodes = interface.secondary.node;
    std::vector<double> weight(conductivity_.size(), 0.0);
    for (const Shell& shell : model.shells) {
        const Material& material =
            model.materials[static_cast<size_t>(model.parts[static_cast<size_t>(shell.part)].material)];
        if (!material.heat) continue;
        const auto& x = model.nodes.position;
        const auto at = [&](size_t j) -> const Vec3& { return x[static_cast<size_t>(shell.node[j])]; };
        const double area = 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).norm();
        const double triangle = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
        const double share = shell.is_triangle() ? triangle / 3.0 : area / 4.0;
        for (int j = 0; j < shell.corners(); ++j) {
            const auto found = std::lower_bound(nodes.begin(), nodes.end(), shell.node[static_cast<size_t>(j)]);
            if (found == nodes.end() || *found != shell.node[static_cast<size_t>(j)]) continue;
            const auto n = static_cast<size_t>(found - nodes.begin());
            conductivity_[n].a += share * material.heat->conductivity_a;
            conductivity_[n].b += share * material.heat->conductivity_b;
            weight[n] += share;
        }
    }
    for (size_t n = 0; n < weight.size(); ++n) {
        if (!(weight[n] > 0)) continue;
        conductivity_[n].a /= weight[n];
        conductivity_[n].b /= weight[n];
    }
}

double HeatExchange::exchange(double pressure) const {
    if (interface_.function_conduction < 0) return interface_.kthe;
    const Function& function = model_.functions[static_cast<size_t>(interface_.function_conduction)];
    return interface_.kthe * function(reading_.conduction_abscissa(interface_, pressure));
}

HeatFlow HeatExchange::flow(int i, const HeatInput& input) const {
    const auto n = static_cast<size_t>(i);
    const double area = interface_.secondary.area[n];
    const double distance = std::max(input.distance, 0.0);
    const HeatZones zones = reading_.heat_zones(interface_, distance, input.gap);
    HeatFlow flow;
    if (!zones.any()) return flow;
    const double conductivity = conductivity_[n].at(input.blank_temperature);
    const double difference = input.tool_temperature - input.blank_temperature;
    double conductance = 0;
    if (zones.conduction) {
        const double pressure = area > 0 ? std::abs(input.normal_force) / area : 0.0;
        conductance = conduction_conductance(exchange(pressure), distance, conductivity);
    } else if (zones.distance) {
        const Function& function = model_.functions[static_cast<size_t>(interface_.function_distance)];
        const double share = function((distance - input.gap) / (interface_.dcond - input.gap));
        conductance = reading_.distance_conductance(exchange(0.0), share, input.gap, conductivity);
    }
    flow.conductance = area * conductance;
    flow.heat = flow.conductance * difference * input.step;
    if (zones.radiation) {
        flow.radiant_conductance =
            area * radiant_conductance(interface_.frad, input.tool_temperature, input.blank_temperature);
        flow.heat += area * radiated(interface_.frad, input.tool_temperature, input.blank_temperature) * input.step;
    }
    return flow;
}

}  // namespace type21::reference
