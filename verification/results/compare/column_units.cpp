#include "verification/results/compare/column_units.h"

#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

#include "verification/results/compare/column_group.h"

namespace type21 {
namespace {

constexpr Dimension impulse_dimension{1, 1, -1, 0};
constexpr Dimension power_dimension{1, 2, -3, 0};

constexpr std::array<std::pair<std::string_view, Dimension>, 4> derived_words{
    {{"N", dim::force}, {"Pa", dim::pressure}, {"J", dim::energy}, {"W", power_dimension}}};
constexpr std::array<std::pair<std::string_view, double>, 7> derived_prefixes{
    {{"", 1}, {"k", 1e3}, {"M", 1e6}, {"G", 1e9}, {"da", 10}, {"m", 1e-3}, {"u", 1e-6}}};

std::optional<Unit> word_unit(std::string word) {
    constexpr std::string_view micro = "\xC2\xB5";
    if (word.starts_with(micro)) word.replace(0, micro.size(), "u");
    if (word == "1" || word == "rad") return Unit{};
    if (word == "K") return Unit{dim::temperature, 1};
    if (word.empty() || std::isdigit(static_cast<unsigned char>(word[0])) != 0 || word[0] == '.') return std::nullopt;
    for (const auto& [base, dimension] : derived_words)
        for (const auto& [prefix, size] : derived_prefixes)
            if (word == std::string(prefix) + std::string(base)) return Unit{dimension, size};
    if (const double size = time_unit(word); size > 0) return Unit{dim::time, size};
    if (const double size = length_unit(word); size > 0) return Unit{dim::length, size};
    if (const double size = mass_unit(word); size > 0) return Unit{dim::mass, size};
    return std::nullopt;
}

void multiply(Unit& product, const Unit& factor, int exponent) {
    product.dimension.mass += exponent * factor.dimension.mass;
    product.dimension.length += exponent * factor.dimension.length;
    product.dimension.time += exponent * factor.dimension.time;
    product.dimension.temperature += exponent * factor.dimension.temperature;
    product.si *= std::pow(factor.si, exponent);
}

/// "^2", "**2", "2", "\u00B2"; 1 without one. Moves `at` behind it.
int read_exponent(std::string_view text, size_t& at) {
    for (const auto& [sign, value] : {std::pair<std::string_view, int>{"\xC2\xB2", 2}, {"\xC2\xB3", 3}})
        if (text.substr(at).starts_with(sign)) {
            at += sign.size();
            return value;
        }
    size_t digit = at;
    if (text.substr(digit).starts_with("**")) digit += 2;
    if (text.substr(digit).starts_with("^")) ++digit;
    const bool negative = text.substr(digit).starts_with("-");
    digit += negative ? 1 : 0;
    if (digit >= text.size() || std::isdigit(static_cast<unsigned char>(text[digit])) == 0) return 1;
    at = digit + 1;
    return (negative ? -1 : 1) * (text[digit] - '0');
}

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

}  // namespace

std::optional<Unit> unit_of(std::string_view text) {
    Unit product;
    bool below = false, in_brackets = false, any = false;
    for (size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at);
        if (rest.starts_with("\xC2\xB7")) {
            at += 2;
        } else if (rest[0] == ' ' || rest[0] == '.' || (rest[0] == '*' && !rest.starts_with("**"))) {
            ++at;
        } else if (rest[0] == '/') {
            below = true;
            ++at;
        } else if (rest[0] == '(' || rest[0] == ')') {
            in_brackets = rest[0] == '(';
            if (!in_brackets) below = false;
            ++at;
        } else {
            size_t end = at;
            // The sign of micro has two bytes.
            while (end < text.size() && (is_letter(text[end]) || text.substr(end).starts_with("\xC2\xB5") ||
                                         (end > at && text[end - 1] == '\xC2')))
                ++end;
            if (end == at && rest[0] == '1') ++end;
            const std::optional<Unit> factor = word_unit(std::string(text.substr(at, end - at)));
            if (!factor || end == at) return std::nullopt;
            at = end;
            const int exponent = read_exponent(text, at);
            multiply(product, *factor, below ? -exponent : exponent);
            any = true;
            if (!in_brackets) below = false;
        }
    }
    return any ? std::optional(product) : std::nullopt;
}

std::optional<Dimension> dimension_of(std::string_view column) {
    const std::string group = unit_group(column);
    if (group == "impulse" || group == "reaction") return impulse_dimension;
    if (group == "moment impulse" || group == "reaction moment") return Dimension{1, 2, -1, 0};
    if (group == "energy") return dim::energy;
    if (group == "length") return dim::length;
    if (group == "velocity") return dim::velocity;
    if (group == "acceleration") return Dimension{0, 1, -2, 0};
    if (group == "angular velocity") return dim::frequency;
    if (group == "TEMP") return dim::temperature;
    return std::nullopt;
}

}  // namespace type21
