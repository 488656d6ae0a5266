#include "reference/host/thermal_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/host/shell_conduction.h"

namespace type21 {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double margin = 0.9;  ///< as of the kinematic limit: conductances change from one cycle to the next

/// Largest K of an interface, its function of pressure taken at its highest point.
double largest_exchange(const Model& model, const Interface& card) {
    if (card.ithe == 0) return 0;
    if (card.function_conduction < 0) return card.kthe;
    const auto& values = model.functions[static_cast<size_t>(card.function_conduction)].y;
    const double highest = values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
    return card.kthe * std::max(highest, 0.0);
}

/// Shares of the nodes of a segment in the heat of an impact, by corner.  Formulation 9, step 11.
std::array<double, 4> shares(const Segment& segment, const Decision& decision) {
    const double a = 1.0 - decision.b - decision.c;
    if (segment.is_triangle()) return {decision.b, decision.c, a, 0.0};
    std::array<double, 4> share;
    share.fill(0.25 * a);
    share[static_cast<size_t>(decision.triangle - 1)] += decision.b;
    share[static_cast<size_t>(decision.triangle % 4)] += decision.c;
    return share;
}

}  // namespace

ThermalLimit::ThermalLimit(const Model& model) : model_(model) {
    for (const Interface& card : model.interfaces) {
        const double exchange = largest_exchange(model, card);
        std::vector<double> touching;
        for (const double area : card.secondary.area)
            touching.push_back(area * exchange);
        largest_touching_.push_back(touching.empty() ? 0.0 : *std::max_element(touching.begin(), touching.end()));
        touching_.push_back(std::move(touching));
    }
}

ThermalLimits ThermalLimit::operator()(const HostState& state, const std::vector<ContactStep>& contacts,
                                       double scale) const {
    const std::vector<double>& capacity = model_.nodal_heat_capacity;
    if (capacity.empty()) return {infinite, infinite};
    std::vector<double> of_contact(capacity.size(), 0.0);
    std::vector<double> all = shell_conductance(model_, state);
    all.resize(capacity.size(), 0.0);
    std::vector<double> of_tool(capacity.size(), 0.0);
    std::vector<double> now = all;  // of this cycle, those to nodes that change count twice
    for (double& sum : now)
        sum *= 2;
    for (size_t i = 0; i < contacts.size(); ++i) {
        const Interface& card = model_.interfaces[i];
        if (card.ithe == 0) continue;
        const ContactStep& contact = contacts[i];
        const auto& segments = model_.surfaces[static_cast<size_t>(card.main_surface)].segments;
        for (size_t n = 0; n < card.secondary.node.size(); ++n) {
            const auto node = static_cast<size_t>(card.secondary.node[n]);
            const NodeHeat heat = contact.heat.empty() ? NodeHeat{} : contact.heat[n];
            const double most = std::max(heat.conductance, touching_[i][n]) + heat.radiant_conductance;
            const double actual = heat.conductance + heat.radiant_conductance;
            of_contact[node] += heat.conductance;
            now[node] += (card.ithe_form == 1 ? 2 : 1) * actual;
            all[node] += most;
            if (card.ithe_form != 1 || contact.nodes.empty()) continue;
            const Decision& decision = contact.nodes[n].decision;
            if (decision.kind == Kind::none) continue;
            const Segment& segment = segments[static_cast<size_t>(decision.segment)];
            const std::array<double, 4> share = shares(segment, decision);
            for (size_t j = 0; j < 4; ++j) {
                of_tool[static_cast<size_t>(segment.node[j])] += std::abs(share[j]) * most;
                now[static_cast<size_t>(segment.node[j])] += 2 * std::abs(share[j]) * actual;
            }
        }
        if (card.ithe_form != 1) continue;
        for (const int node : card.main_nodes) {
            double& sum = of_tool[static_cast<size_t>(node)];
            sum = std::max(sum, largest_touching_[i]);
        }
    }
    ThermalLimits limits{infinite, infinite};
    for (size_t n = 0; n < capacity.size(); ++n) {
        if (!(capacity[n] > 0)) continue;
        if (of_contact[n] > 0) limits.step = std::min(limits.step, scale * 2.0 * capacity[n] / of_contact[n]);
        const double sum = all[n] + of_tool[n];
        if (sum > 0) limits.step = std::min(limits.step, margin * capacity[n] / sum);
        if (now[n] > 0) limits.stable = std::min(limits.stable, 2.0 * capacity[n] / now[n]);
    }
    return limits;
}

}  // namespace type21
