// Heat between tool and blank.
#include "verification/criteria/mutation/break_contact.h"

namespace type21 {

std::vector<Mutation> heat_mutations() {
    using enum Effect;
    const auto changed = [](auto change) { return broken_card([=](ContactModel&, Interface& card) { change(card); }); };
    const auto such = [](auto condition) {
        return has_card([=](const Interface& c) { return c.ithe != 0 && condition(c); });
    };
    return {
        {"heat_off",
         "Ithe",
         "no heat flows",
         has_effect(heat),
         broken_step([](const Scene&, int) {
             return [](ContactStep& step, const Motion&) {
                 for (NodeHeat& node : step.heat)
                     node.heat = node.friction_heat = 0;
                 step.tool_heat.clear();
                 step.sums.heat_to_blank = step.sums.heat_to_tool = step.sums.friction_heat = 0;
             };
         }),
         {}},
        {"heat_halved",
         "heat flow",
         "half of the heat flows",
         has_effect(heat),
         broken_step([](const Scene&, int) {
             return [](ContactStep& step, const Motion&) {
                 for (NodeHeat& node : step.heat)
                     node.heat *= 0.5;
                 for (ToolHeat& heat : step.tool_heat)
                     heat.heat *= 0.5;
                 step.sums.heat_to_blank *= 0.5;
                 step.sums.heat_to_tool *= 0.5;
             };
         }),
         {}},
        {"kthe_millionth",
         "Kthe",
         "conductance larger by a millionth",
         such([](const Interface& c) { return c.kthe > 0; }),
         changed([](Interface& c) { c.kthe.value *= 1 + 1e-6; }),
         {}},
        {"conductance_of_pressure_off",
         "fct_IDK",
         "Kthe for every pressure",
         such([](const Interface& c) { return c.function_conduction >= 0; }),
         changed([](Interface& c) { c.function_conduction = -1; }),
         {}},
        {"conductance_of_distance_off",
         "Fcond, Dcond",
         "no conduction beyond the gap",
         such([](const Interface& c) { return c.function_distance >= 0; }),
         changed([](Interface& c) { c.function_distance = -1; }),
         {}},
        {"radiation_off",
         "Frad",
         "no radiation",
         such([](const Interface& c) { return c.frad > 0; }),
         changed([](Interface& c) { c.frad.value = 0; }),
         {}},
        {"radiation_millionth",
         "Frad",
         "radiation larger by a millionth",
         such([](const Interface& c) { return c.frad > 0; }),
         changed([](Interface& c) { c.frad.value *= 1 + 1e-6; }),
         {}},
        {"drad_halved",
         "Drad",
         "radiation reaches half as far",
         such([](const Interface& c) { return c.frad > 0 && c.drad > 0; }),
         changed([](Interface& c) { c.drad.value *= 0.5; }),
         {}},
        {"friction_heat_off",
         "Fheat",
         "sliding does not heat",
         such([](const Interface& c) { return c.fheat > 0; }),
         changed([](Interface& c) { c.fheat.value = 0; }),
         {}},
        {"tint_off",
         "Tint",
         "the tool is a degree warmer",
         such([](const Interface& c) { return c.ithe_form == 0; }),
         changed([](Interface& c) { c.tint.value += 1; }),
         {}},
        {"ithe_form_off",
         "Ithe_form 1",
         "the tool has the temperature Tint",
         such([](const Interface& c) { return c.ithe_form == 1; }),
         changed([](Interface& c) { c.ithe_form.value = 0; }),
         {}},
        {"tool_not_heated",
         "Ithe_form 1",
         "the tool does not receive the heat of the blank",
         such([](const Interface& c) { return c.ithe_form == 1; }),
         broken_step(
             [](const Scene&, int) { return [](ContactStep& step, const Motion&) { step.tool_heat.clear(); }; }),
         {}},
        {"conductance_off",
         "thermal time step",
         "the contact does not limit the thermal step",
         such([](const Interface& c) { return c.kthe > 0; }),
         broken_step([](const Scene&, int) {
             return [](ContactStep& step, const Motion&) {
                 for (NodeHeat& node : step.heat)
                     node.conductance = 0;
             };
         }),
         {}},
    };
}

}  // namespace type21
