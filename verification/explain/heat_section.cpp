/// @file Heat of the node: chapter 9 of the formulation.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reference/contact/heat_exchange.h"
#include "verification/explain/node_account.h"

namespace type21 {

using namespace reference;

AccountSection heat_section(const AccountInput& input, const NodeContact& node) {
    const Interface& card = input.card();
    const HeatExchange& exchange = *input.inspect.heat_exchange();
    const double area = card.secondary.area[static_cast<size_t>(input.node)];
    const double d = std::max(node.distance, 0.0);
    const double blank = input.motion.temperature[static_cast<size_t>(input.model_node())];
    const double tool = input.inspect.tool_temperature(node.decision, input.motion);
    const HeatZones zones = input.inspect.reading().heat_zones(card, d, node.gap);
    const std::string kelvin = input.unit(dim::temperature);
    const std::string energy = input.unit(dim::energy);
    AccountSection section{"heat", {}};
    section.add("T_s", "", "", blank, kelvin, "of the node");
    section.add("T_m", exchange.tool_has_temperatures() ? "a T_A + b T_B + c T_C" : "Tint", "", tool, kelvin,
                "manual page, comment 16");
    section.add("d", "max(delta, 0)", "", d, input.unit(dim::length),
                zones.conduction ? "<= g: conduction"
                : zones.any()    ? fmt::format("> g:{}{}", zones.distance ? " conduction over the distance" : "",
                                            zones.radiation ? " radiation" : "")
                                 : "> g: no heat");
    const double step = input.motion.step;
    const HeatFlow flow = exchange.flow(input.node, {node.distance, node.gap, node.normal_force, step, blank, tool});
    const NodeHeat& heat = input.step.heat[static_cast<size_t>(input.node)];
    const double conductivity = exchange.conductivity(input.node).at(blank);
    const std::string conductance = input.unit(dim::conductance);
    if (zones.conduction || zones.distance)
        section.add("k_s", "A_S + B_S T_s", "", conductivity, input.unit({1, 1, -3, -1}), "Formulation 9, step 7");
    const double pressure = zones.conduction && area > 0 ? std::abs(node.normal_force) / area : 0.0;
    if (zones.conduction) {
        const bool d38 = input.model().as_built.has(Departure::D38);
        const char* const scale = d38 ? "Kthe f_K(AscaleK |F_n|/A)" : "Kthe f_K(|F_n|/(A AscaleK))";
        section.add("K", card.function_conduction < 0 ? "Kthe" : scale, "", exchange.exchange(pressure), conductance,
                    card.function_conduction < 0 ? "manual page, equation (14)" : "manual page, equation (15)");
        section.add("A/(d/k_s + 1/K)", "",
                    fmt::format("{}/({}/{} + 1/{})", digits(area), digits(d), digits(conductivity),
                                digits(exchange.exchange(pressure))),
                    flow.conductance, input.unit({1, 2, -3, -1}), "manual page, equation (14)");
    } else if (zones.distance) {
        const Function& f = input.model().functions[static_cast<size_t>(card.function_distance)];
        const double share = (d - node.gap) / (card.dcond - node.gap);
        section.add("f", "f_cond((d - g)/(Dcond - g))", fmt::format("f_cond({})", digits(share)), f(share), "",
                    "manual page, equation (20)");
        section.add("A/(g/k_s + 1/(K f))", "",
                    fmt::format("{}/({}/{} + 1/({} x {}))", digits(area), digits(node.gap), digits(conductivity),
                                digits(exchange.exchange(0.0)), digits(f(share))),
                    flow.conductance, input.unit({1, 2, -3, -1}), "manual page, equation (20)");
    }
    if (zones.radiation)
        section.add("radiated", "Frad A (T_m^4 - T_s^4) dt",
                    fmt::format("{} x {} x ({}^4 - {}^4) x {}", digits(card.frad), digits(area), digits(tool),
                                digits(blank), digits(step)),
                    area * radiated(card.frad, tool, blank) * step, energy, "manual page, equation (17)");
    if (zones.conduction || zones.distance)
        section.add(
            "conducted", "conductance x (T_m - T_s) dt",
            fmt::format("{} x ({} - {}) x {}", digits(flow.conductance), digits(tool), digits(blank), digits(step)),
            flow.conductance * (tool - blank) * step, energy,
            zones.conduction ? "manual page, equation (14)" : "manual page, equation (20)");
    section.add("Phi", "from the tool in this cycle", "", flow.heat, energy, "Formulation 9, step 12");
    section.add("Fheat q", "friction heat", "", heat.friction_heat, energy, "manual page, equation (19)");
    section.add("to node", "Phi + Fheat q", "", heat.heat, energy, "Formulation 9, step 12");
    return section;
}

}  // namespace type21
