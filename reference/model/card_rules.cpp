/// @file Messages of rules that many fields share.
#include "reference/model/card_rules.h"

#include <algorithm>

#include <fmt/format.h>

namespace type21 {

bool among(int value, std::initializer_list<int> allowed) {
    return std::find(allowed.begin(), allowed.end(), value) != allowed.end();
}

void one_of(const CardValidator& validator, std::string_view field, int value, std::initializer_list<int> allowed) {
    if (among(value, allowed)) return;
    validator.error(field, fmt::format("must be one of {}", fmt::join(allowed, ", ")), "Give one of these values");
}

void not_negative(const CardValidator& validator, std::string_view field, double value) {
    if (value < 0) validator.error(field, "must not be negative", "Give 0 for the default, or a positive value");
}

void unused(const CardValidator& validator, std::string_view field, bool given, std::string_view reason) {
    if (given)
        validator.warning(field, fmt::format("has no effect: {}", reason), "Leave it blank to keep the deck clear");
}

}  // namespace type21
