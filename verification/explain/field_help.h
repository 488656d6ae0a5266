/// @file The meaning of each field of the twelve card lines. Columns, units and defaults come from the model.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/contract/departures.h"
#include "reference/model/interface_fields.h"

namespace type21 {

struct FieldHelp {
    std::string_view name;  ///< as in interface_fields()
    std::string_view meaning;
    std::string_view rule;    ///< values and their effect
    std::string_view source;  ///< equation and comment of the manual page, step of the formulation
    std::vector<Departure> departures;
};

/// In the order of the card.
const std::vector<FieldHelp>& field_help();

/// The parts of field_help().
std::vector<FieldHelp> field_help_surfaces();  ///< lines 1 to 5
std::vector<FieldHelp> field_help_friction();  ///< lines 6 to 8
std::vector<FieldHelp> field_help_heat();      ///< lines 9 to 12

/// The entry of a name in any case, nullptr if it is no field of the card.
const FieldHelp* find_field_help(std::string_view name);

/// A case that covers something: "eq 5", "field DEPTH", "comment 4" or "departure D03".
struct CaseCover {
    std::string name;
    std::vector<std::string> covers;
};

/// The help text of a field: place on the card, unit, default as the model resolves a blank card, departures, cases.
std::string field_text(const FieldHelp& help, std::span<const CaseCover> cases);

/// The help text of a departure: as documented, as built, whether it can be switched on, its fields, cases.
std::string departure_text(const DepartureRow& row, std::span<const CaseCover> cases);

}  // namespace type21
