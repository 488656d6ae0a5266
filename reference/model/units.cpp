#include "reference/model/units.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reference/model/numbers.h"

namespace type21 {

namespace {

double power(double base, int exponent) {
    double product = 1;
    for (int i = 0; i < std::abs(exponent); ++i)
        product *= base;
    return exponent < 0 ? 1 / product : product;
}

struct Prefix {
    std::string_view text;
    int exponent;
};

/// The prefixes of the SI; micro is written mu or u in a deck.
constexpr std::array<Prefix, 22> prefixes{{{"Y", 24},  {"Z", 21},  {"E", 18},  {"P", 15}, {"T", 12}, {"G", 9},
                                           {"M", 6},   {"k", 3},   {"h", 2},   {"da", 1}, {"", 0},   {"d", -1},
                                           {"c", -2},  {"m", -3},  {"mu", -6}, {"u", -6}, {"n", -9}, {"p", -12},
                                           {"f", -15}, {"a", -18}, {"z", -21}, {"y", -24}}};

/// Size in SI of a word: a plain number, a prefix with the base unit, or one of the other units. 0 if none of them.
double unit(std::string_view text, std::string_view base, int base_exponent,
            std::initializer_list<std::pair<std::string_view, double>> others) {
    double factor = 0;
    if (parse_real(text, factor) == NumberFault::none) return factor > 0 ? factor : 0;
    for (const auto& [word, size] : others) {
        if (text == word) return size;
    }
    for (const Prefix& prefix : prefixes) {
        if (text.size() != prefix.text.size() + base.size()) continue;
        if (!text.starts_with(prefix.text) || !text.ends_with(base)) continue;
        // Read as a decimal, so that "Mg" is the same double as "1000".
        parse_real(fmt::format("1e{}", prefix.exponent + base_exponent), factor);
        return factor;
    }
    return 0;
}

struct Derived {
    Dimension dimension;
    double si;
    std::string_view name;
};

constexpr std::array<Derived, 9> derived_units{{{dim::force, 1, "N"},
                                                {dim::force, 1e3, "kN"},
                                                {dim::pressure, 1, "Pa"},
                                                {dim::pressure, 1e6, "MPa"},
                                                {dim::pressure, 1e9, "GPa"},
                                                {dim::energy, 1e-3, "mJ"},
                                                {dim::energy, 1, "J"},
                                                {dim::energy, 1e3, "kJ"},
                                                {dim::energy, 1e6, "MJ"}}};

constexpr Dimension impulse{1, 1, -1, 0};

std::string derived_name(const UnitSystem& system, Dimension dimension) {
    for (const Derived& unit : derived_units) {
        if (unit.dimension == dimension && std::abs(system.si(dimension) / unit.si - 1) < 1e-12) {
            return std::string(unit.name);
        }
    }
    return {};
}

}  // namespace

double UnitSystem::si(Dimension dimension) const {
    return power(mass, dimension.mass) * power(length, dimension.length) * power(time, dimension.time);
}

std::string UnitSystem::name(Dimension dimension) const {
    if (std::string known = derived_name(*this, dimension); !known.empty()) return known;
    if (dimension == dim::stiffness) {
        if (const std::string force = derived_name(*this, dim::force); !force.empty()) return force + "/" + length_name;
    }
    if (dimension == impulse) {
        if (const std::string force = derived_name(*this, dim::force); !force.empty()) return force + " " + time_name;
    }
    const std::array<std::pair<std::string, int>, 4> factors{{{mass_name, dimension.mass},
                                                              {length_name, dimension.length},
                                                              {time_name, dimension.time},
                                                              {"K", dimension.temperature}}};
    std::string above;
    std::string below;
    int below_count = 0;
    for (const auto& [name, exponent] : factors) {
        if (exponent == 0) continue;
        std::string& side = exponent > 0 ? above : below;
        below_count += exponent < 0 ? 1 : 0;
        if (!side.empty()) side += ' ';
        side += std::abs(exponent) == 1 ? name : fmt::format("{}^{}", name, std::abs(exponent));
    }
    if (below.empty()) return above;
    const std::string divisor = below_count > 1 ? "(" + below + ")" : below;
    return fmt::format("{}/{}", above.empty() ? "1" : above, divisor);
}

double conversion(const UnitSystem& from, const UnitSystem& to, Dimension dimension) {
    return power(from.mass / to.mass, dimension.mass) * power(from.length / to.length, dimension.length) *
           power(from.time / to.time, dimension.time);
}

double mass_unit(const std::string& text) {
    return unit(text, "g", -3, {{"t", 1000.0}, {"lb", 0.45359237}});
}

double length_unit(const std::string& text) {
    return unit(text, "m", 0, {{"in", 0.0254}, {"ft", 0.3048}});
}

double time_unit(const std::string& text) {
    return unit(text, "s", 0, {{"min", 60.0}, {"h", 3600.0}});
}

}  // namespace type21
