// Heat of one secondary node in one cycle: chapter 9 of the formulation, steps 4 to 11.
#include "reference/cycle/contact_state.h"

namespace type21::reference {

void Contact::State::heat(int i, const Motion& motion, const NodeContact& node, ContactStep& step) const {
    if (!heat_exchange) return;
    NodeHeat& out = step.heat[static_cast<size_t>(i)];
    HeatInput input;
    input.distance = node.distance;
    input.gap = node.gap;
    input.normal_force = node.normal_force;
    input.step = motion.step;
    input.blank_temperature = motion.temperature[model_node(i)];
    // Formulation 9, step 4: temperature of the tool.
    input.tool_temperature = tool_temperature(node.decision, motion);
    // Formulation 9, step 6 to step 9: zones, conduction, radiation.
    const HeatFlow flow = heat_exchange->flow(i, input);
    out.conductance = flow.conductance;
    out.radiant_conductance = flow.radiant_conductance;
    // Formulation 9, step 10: friction heat.
    out.heat = flow.heat + out.friction_heat;
    // Formulation 9, step 11: the tool loses what the blank gets from it.
    if (heat_exchange->heats_tool())
        heat_tool(node.decision, -flow.heat + reading.friction_heat_to_tool * out.friction_heat, step);
}

void Contact::State::heat_tool(const Decision& decision, double heat, ContactStep& step) const {
    const auto& corner = surface.nodes(decision.segment);
    const double a = 1.0 - decision.b - decision.c;
    if (corner[2] == corner[3]) {
        step.tool_heat.push_back({corner[2], a * heat});
        step.tool_heat.push_back({corner[0], decision.b * heat});
        step.tool_heat.push_back({corner[1], decision.c * heat});
        return;
    }
    for (const int node : corner)
        step.tool_heat.push_back({node, 0.25 * a * heat});
    step.tool_heat.push_back({corner[static_cast<size_t>(decision.triangle - 1)], decision.b * heat});
    step.tool_heat.push_back({corner[static_cast<size_t>(decision.triangle % 4)], decision.c * heat});
}

double Contact::State::tool_temperature(const Decision& decision, const Motion& motion) const {
    if (!heat_exchange || !heat_exchange->tool_has_temperatures()) return card().tint;
    const auto& corner = surface.nodes(decision.segment);
    const auto at = [&](int j) { return motion.temperature[static_cast<size_t>(corner[static_cast<size_t>(j)])]; };
    const double a = 1.0 - decision.b - decision.c;
    if (corner[2] == corner[3]) return a * at(2) + decision.b * at(0) + decision.c * at(1);
    const double center = 0.25 * (at(0) + at(1) + at(2) + at(3));
    return a * center + decision.b * at(decision.triangle - 1) + decision.c * at(decision.triangle % 4);
}

}  // namespace type21::reference
