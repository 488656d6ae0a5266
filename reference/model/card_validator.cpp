/// @file Messages of the TYPE21 card.
#include "reference/model/card_validator.h"

#include <algorithm>

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/interface_fields.h"

namespace type21 {
namespace {

const InterfaceField& find_field(std::string_view name) {
    const auto& fields = interface_fields();
    return *std::find_if(fields.begin(), fields.end(), [&](const InterfaceField& field) { return field.name == name; });
}

std::string shown(const InterfaceField& field, const CardValidator& validator) {
    const std::string unit = validator.model.units.name(dimension(field, validator.interface));
    return with_field(validator.interface, field, [&](const auto& value) {
        return fmt::format("{}{}{}", value.value, unit.empty() ? "" : " ", unit);
    });
}

}  // namespace

CardReading CardValidator::reading() const {
    return card_reading(model.as_built);
}

void CardValidator::error(std::string_view field, std::string rule, std::string remedy) const {
    error_with(field, shown(find_field(field), *this), std::move(rule), std::move(remedy));
}

void CardValidator::warning(std::string_view field, std::string rule, std::string remedy) const {
    warning_with(field, shown(find_field(field), *this), std::move(rule), std::move(remedy));
}

void CardValidator::error_with(std::string_view field, std::string value, std::string rule, std::string remedy) const {
    card.error(find_field(field).line, field, std::move(value), std::move(rule), std::move(remedy));
}

void CardValidator::warning_with(std::string_view field, std::string value, std::string rule,
                                 std::string remedy) const {
    card.warning(find_field(field).line, field, std::move(value), std::move(rule), std::move(remedy));
}

std::string CardValidator::length(double value) const {
    return fmt::format("{} {}", value, model.units.name(dim::length));
}

std::string first_few(const std::vector<Id>& ids) {
    constexpr size_t few = 5;
    const std::vector<Id> head(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(std::min(few, ids.size())));
    std::string text = fmt::format("{}", fmt::join(head, ", "));
    if (ids.size() > few) text += fmt::format(" and {} more", ids.size() - few);
    return text;
}

}  // namespace type21
