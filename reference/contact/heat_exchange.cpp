#include "reference/contact/heat_exchange.h"

#include <algorithm>
#include <cmath>

namespace type21::reference {

HeatZones heat_zones(const Interface& interface, double distance, double gap, const AsBuilt& as_built) {
    HeatZones zones;
    zones.conduction = distance <= gap;
    if (zones.conduction) return zones;
    zones.distance = interface.function_distance >= 0 && distance <= interface.dcond;
    // D15: the distance beyond the gap is compared with Drad.
    const double reach = as_built.has(Departure::D15) ? distance - gap : distance;
    zones.radiation = interface.frad > 0 && reach <= interface.drad;
    return zones;
}

double conduction_conductance(double exchange, double distance, double conductivity) {
    if (exchange <= 0) return 0;
    if (distance <= 0) return exchange;
    if (conductivity <= 0) return 0;
    return 1.0 / (distance / conductivity + 1.0 / exchange);
}

double distance_conductance(double exchange, double share, double gap, double conductivity, const AsBuilt& as_built) {
    if (as_built.has(Departure::D32)) return share * conduction_conductance(exchange, gap, conductivity);
    return conduction_conductance(exchange * share, gap, conductivity);
}

double radiated(double frad, double tool_temperature, double blank_temperature) {
    const double tool2 = tool_temperature * tool_temperature;
    const double blank2 = blank_temperature * blank_temperature;
    // (T_m^4 - T_s^4) without the cancellation of two large powers.
    return frad * (tool2 + blank2) * (tool_temperature + blank_temperature) * (tool_temperature - blank_temperature);
}

HeatExchange::HeatExchange(const ContactModel& model, const Interface& interface)
    : model_(model), interface_(interface), conductivity_(static_cast<size_t>(interface.secondary.size())) {
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
    return interface_.kthe * function(interface_.ascalek * pressure);
}

HeatFlow HeatExchange::flow(int i, const HeatInput& input) const {
    const auto n = static_cast<size_t>(i);
    const double area = interface_.secondary.area[n];
    const double distance = std::max(input.distance, 0.0);
    const HeatZones zones = heat_zones(interface_, distance, input.gap, model_.as_built);
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
        conductance = distance_conductance(exchange(0.0), share, input.gap, conductivity, model_.as_built);
    }
    flow.conductance = area * conductance;
    flow.heat = flow.conductance * difference * input.step;
    if (zones.radiation) {
        flow.heat += area * radiated(interface_.frad, input.tool_temperature, input.blank_temperature) * input.step;
    }
    return flow;
}

}  // namespace type21::reference
