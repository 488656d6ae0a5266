#include "reference/host/effect_checks.h"

#include <algorithm>

#include <fmt/format.h>

#include "reference/host/when.h"

namespace type21 {

namespace {

bool imposes_below_zero(const Model& model, const ImposedTemperature& imposed) {
    if (imposed.function < 0) return false;
    const auto& values = model.functions[static_cast<size_t>(imposed.function)].y;
    return std::any_of(values.begin(), values.end(), [&](double value) { return value * imposed.scale_y < 0; });
}

}  // namespace

bool absolute_temperatures(const Model& model) {
    const bool radiates = std::any_of(model.interfaces.begin(), model.interfaces.end(),
                                      [](const Interface& card) { return card.ithe > 0 && card.frad > 0; });
    return radiates ||
           std::none_of(model.imposed_temperatures.begin(), model.imposed_temperatures.end(),
                        [&](const ImposedTemperature& imposed) { return imposes_below_zero(model, imposed); });
}

void check_temperatures(const Model& model, const HostState& state, bool absolute) {
    if (!absolute || state.temperature.empty()) return;
    const auto coldest = std::min_element(state.temperature.begin(), state.temperature.end());
    if (!(*coldest < 0)) return;
    const auto below =
        std::count_if(state.temperature.begin(), state.temperature.end(), [](double value) { return value < 0; });
    throw RunStopped(
        RunStopped::Why::diverged,
        fmt::format("the temperature of node {} is {:.6g} {}, below absolute zero, {} ({} node{}); take a smaller step "
                    "by /DTIX or /DT/NODA, or look for what cools the node",
                    model.nodes.id[static_cast<size_t>(coldest - state.temperature.begin())], *coldest,
                    model.units.name(dim::temperature), when(state, model.units), below, below == 1 ? "" : "s"));
}

void check_friction(const Model& model, const HostState& state, const std::vector<ContactStep>& steps) {
    for (size_t i = 0; i < steps.size(); ++i) {
        const FrictionOverflow& overflow = steps[i].friction_overflow;
        if (overflow.count == 0) continue;
        const Interface& card = model.interfaces[i];
        throw RunStopped(
            RunStopped::Why::diverged,
            fmt::format(
                "the friction coefficient of interface {} (Ifric {}) is not a finite number with C{} = {:.6g} at "
                "the sliding speed {:.6g} {} and the pressure {:.6g} {}, node {}, {} ({} node{}); give a "
                "coefficient that suits the speeds of the deck and its units",
                card.id, card.ifric.value, overflow.coefficient + 1, overflow.value, overflow.speed,
                model.units.name(dim::velocity), overflow.pressure, model.units.name(dim::pressure),
                model.nodes.id[static_cast<size_t>(overflow.node)], when(state, model.units), overflow.count,
                overflow.count == 1 ? "" : "s"));
    }
}

FrictionReport::FrictionReport(const Model& model, const HostState& state, const MarchOptions& options)
    : model_(model), state_(state), options_(options), below_zero_(model.interfaces.size()) {}

FrictionReport::~FrictionReport() {
    if (!options_.warn) return;
    for (size_t i = 0; i < below_zero_.size(); ++i)
        if (below_zero_[i].count > 0) options_.warn(warning_of(below_zero_[i], model_, model_.interfaces[i]));
}

void FrictionReport::note(const std::vector<ContactStep>& steps) {
    for (size_t i = 0; i < steps.size(); ++i) {
        const FrictionBelowZero& now = steps[i].friction_below_zero;
        if (now.count == 0) continue;
        BelowZero& all = below_zero_[i];
        if (all.count == 0) all = {0, now.node, now.abscissa, now.coefficient, state_.cycle, state_.time};
        all.count += now.count;
    }
}

/// @manual field fct_IDF; departure D39
std::string warning_of(const BelowZero& all, const Model& model, const Interface& card) {
    return fmt::format(
        "interface {}: fct_IDF {} makes the friction coefficient {:.6g} at the temperature {:.6g} {} (AscaleF {:.6g}), "
        "first at node {} in cycle {} at t = {:.9g} {}, {} time{} in all; {}. End the function with a horizontal piece "
        "that is not below 0",
        card.id, card.fct_idf.value, all.coefficient, all.abscissa / card.ascalef, model.units.name(dim::temperature),
        card.ascalef.value, model.nodes.id[static_cast<size_t>(all.node)], all.cycle, all.time,
        model.units.name(dim::time), all.count, all.count == 1 ? "" : "s",
        model.as_built.has(Departure::D39) ? "D39: friction then drives the sliding" : "it is taken as 0");
}

}  // namespace type21
