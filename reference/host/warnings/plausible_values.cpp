/// @file Densities, thicknesses and friction that no sheet or tool has: most often a unit that was missed.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "reference/host/warnings/warnings.h"

namespace type21 {
namespace {

struct Range {
    double low = 0, high = 0;  ///< in SI units
    Dimension dimension;
    std::string_view what;
};

// Foam to osmium; quasi-static forming is run with up to a thousand times the mass.
constexpr Range densities{10, 30'000'000, dim::density, "from a foam to a metal with a thousand times its mass"};
// Foil to armour.
constexpr Range thicknesses{5e-6, 0.1, dim::length, "from a foil to a plate"};
// Polymer to tungsten carbide.
constexpr Range moduli{1e5, 2e12, dim::pressure, "from a rubber to a hard metal"};
constexpr double most_friction = 1.0;

/// A range in the work units of the deck, as text.
std::string text_of(const Range& range, const SurpriseCheck& check) {
    const double unit = check.model.units.si(range.dimension);
    return fmt::format("{:.3g} to {}", range.low / unit, check.quantity(range.high / unit, range.dimension));
}

/// 0 is the default of a field, or no value at all.
bool is_implausible(double value, const Range& range, const SurpriseCheck& check) {
    const double si = value * check.model.units.si(range.dimension);
    return value != 0 && !(si >= range.low && si <= range.high);
}

void judge(const SurpriseCheck& check, std::string_view card, Id id, std::string_view field, double value,
           const Range& range) {
    if (!is_implausible(value, range, check)) return;
    check.at_card(card, id, field, check.quantity(value, range.dimension),
                  fmt::format("is outside of what is usual, {} ({})", text_of(range, check), range.what),
                  "Check the number and its unit");
}

/// Shells with a thickness of their own that is implausible, all in one message.
void judge_shells(const SurpriseCheck& check) {
    const Shell* first = nullptr;
    int count = 0;
    for (const Shell& shell : check.model.shells) {
        const int property = check.model.parts[static_cast<size_t>(shell.part)].property;
        const bool own =
            property < 0 || shell.thickness != check.model.properties[static_cast<size_t>(property)].thickness;
        if (!own || !is_implausible(shell.thickness, thicknesses, check)) continue;
        if (count++ == 0) first = &shell;
    }
    if (first == nullptr) return;
    check.at_card("SHELL", check.model.parts[static_cast<size_t>(first->part)].id, "Thick",
                  fmt::format("{} of element {}, {} element{} in all", check.quantity(first->thickness, dim::length),
                              first->id, count, count == 1 ? "" : "s"),
                  fmt::format("is outside of what is usual, {} ({})", text_of(thicknesses, check), thicknesses.what),
                  "Check the number and its unit");
}

void judge_friction(const SurpriseCheck& check, std::string_view card, Id id, double value) {
    check.at_card(card, id, "Fric", fmt::format("{:.6g}", value),
                  "is a coefficient of friction above 1: metal on metal has 0.01 to 0.5",
                  "Check the number: it is neither an angle nor a percentage");
}

}  // namespace

void warn_of_implausible_values(const SurpriseCheck& check) {
    for (const Material& material : check.model.materials) {
        judge(check, "MAT", material.id, "rho_i", material.density, densities);
        if (material.law != MaterialLaw::none) judge(check, "MAT", material.id, "E", material.young, moduli);
    }
    for (const Property& property : check.model.properties)
        judge(check, "PROP", property.id, "Thick", property.thickness, thicknesses);
    judge_shells(check);
    for (const Part& part : check.model.parts)
        judge(check, "PART", part.id, "Thick", part.contact_thickness, thicknesses);
    for (const FrictionModel& friction : check.model.friction_models) {
        const auto high = std::find_if(friction.pairs.begin(), friction.pairs.end(),
                                       [](const FrictionPair& pair) { return pair.coefficients.fric > most_friction; });
        if (high != friction.pairs.end()) judge_friction(check, "FRICTION", friction.id, high->coefficients.fric);
        if (friction.fallback.fric > most_friction)
            judge_friction(check, "FRICTION", friction.id, friction.fallback.fric);
    }
    for (const Interface& interface : check.model.interfaces) {
        if (interface.friction_model < 0 && interface.fric > most_friction)
            judge_friction(check, "INTER", interface.id, interface.fric);
    }
}

}  // namespace type21
