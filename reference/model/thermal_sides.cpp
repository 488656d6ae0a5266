/// @file Which nodes can hold heat, and which have a temperature.
#include <algorithm>

#include <fmt/format.h>

#include "reference/model/heat_rules.h"

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

bool holds_heat(const Model& model, int node) {
    return !model.nodal_heat_capacity.empty() && model.nodal_heat_capacity[at(node)] > 0;
}

/// In a group that one of these conditions names.
template <class Condition>
bool in_group_of(const Model& model, const std::vector<Condition>& conditions, int node) {
    return std::any_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
        if (condition.group < 0) return false;
        const std::vector<int>& nodes = model.groups[at(condition.group)].nodes;
        return std::binary_search(nodes.begin(), nodes.end(), node);
    });
}

/// "9 nodes: 1001, 1002 and 7 more" of those that fail; empty when none does.
template <class Good>
std::string failing(const Model& model, const std::vector<int>& nodes, Good&& good) {
    std::vector<Id> ids;
    for (const int node : nodes)
        if (!good(node)) ids.push_back(model.nodes.id[at(node)]);
    return ids.empty() ? "" : fmt::format("{} nodes: {}", ids.size(), first_few(ids));
}

}  // namespace

/// @manual field Ithe, Ithe_form
void check_thermal_sides(const CardValidator& validator) {
    const Interface& it = validator.interface;
    const Model& model = validator.model;
    if (it.ithe == 0) return;
    const std::string blank = failing(model, it.secondary.node, [&](int node) { return holds_heat(model, node); });
    if (!blank.empty())
        validator.error_with("Ithe", blank, "every secondary node needs a heat capacity: that of a thermal material",
                             "Add /HEAT/MAT for the materials of the secondary shells, or set Ithe to 0");
    const auto imposed = [&](int node) { return in_group_of(model, model.imposed_temperatures, node); };
    if (it.ithe_form == 1) {
        const std::string tool =
            failing(model, it.main_nodes, [&](int node) { return holds_heat(model, node) || imposed(node); });
        if (!tool.empty())
            validator.error_with("Ithe_form", tool,
                                 "with Ithe_form 1 the tool is heated: every main node needs a heat capacity",
                                 "Add /HEAT/MAT for the tool's material, or impose its temperature by /IMPTEMP");
    } else if (it.ithe == 2) {
        const std::string tool = failing(model, it.main_nodes, [&](int node) {
            return holds_heat(model, node) || imposed(node) || in_group_of(model, model.initial_temperatures, node);
        });
        if (!tool.empty())
            validator.error_with("Ithe", tool,
                                 "with Ithe 2 the tool has the temperatures of its nodes, and these have none",
                                 "Give them by /IMPTEMP, by /INITEMP or by /HEAT/MAT of the tool's material");
    }
}

}  // namespace type21
