/// @file Every field of an interface card as text, with its unit and origin.
#pragma once

#include <string>
#include <vector>

#include "reference/contract/interface.h"
#include "reference/model/units.h"

namespace type21 {

/// One row of the table that `type21 check` prints.
struct FieldRow {
    int card_line = 0;  ///< 1..12
    std::string name;   ///< as on the manual page
    std::string value;
    std::string unit;
    Origin origin;
};

/// Every field of the twelve lines, in the order of the card.
std::vector<FieldRow> field_table(const Interface& interface, const UnitSystem& units);

}  // namespace type21
