/// @file Every field of the twelve lines as text, for `type21 check` and run.json.
#include "reference/model/field_table.h"

#include <fmt/format.h>

#include "reference/model/interface_fields.h"

namespace type21 {
namespace {

std::string value_text(const InterfaceField& field, const Interface& interface) {
    if (field.name == "IBC") return fmt::format("{:03b}", interface.ibc.value);
    return with_field(interface, field, [](const auto& value) { return fmt::format("{}", value.value); });
}

std::string unit_text(const InterfaceField& field, const Interface& interface, const UnitSystem& units) {
    if (field.name == "Angladm") return "deg";
    return units.name(dimension(field, interface));
}

}  // namespace

std::vector<FieldRow> field_table(const Interface& interface, const UnitSystem& units) {
    std::vector<FieldRow> rows;
    for (const InterfaceField& field : interface_fields())
        rows.push_back({field.line, std::string(field.name), value_text(field, interface),
                        unit_text(field, interface, units),
                        with_field(interface, field, [](const auto& value) { return value.origin; })});
    return rows;
}

}  // namespace type21
