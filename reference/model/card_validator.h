/// @file One TYPE21 card while its rules are applied: what they may read, change and report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/model/card_reader.h"
#include "reference/model/model.h"

namespace type21 {

struct CardReading;

/// A card with what its rules may read and change.
struct CardValidator {
    CardReader& card;
    const Model& model;
    Interface& interface;

    /// The rules that hold for this card, as documented or as built.
    CardReading reading() const;

    /// Reports a problem at the field's line, with its value and unit as read.
    /// @param field  name as on the manual page; it must be one of interface_fields()
    void error(std::string_view field, std::string rule, std::string remedy) const;
    void warning(std::string_view field, std::string rule, std::string remedy) const;
    /// The same with another value, such as a list of nodes.
    void error_with(std::string_view field, std::string value, std::string rule, std::string remedy) const;
    void warning_with(std::string_view field, std::string value, std::string rule, std::string remedy) const;

    /// "2.5 mm"
    std::string length(double value) const;
};

/// "17, 18, 19 and 4 more": one message for many nodes or segments.
std::string first_few(const std::vector<Id>& ids);

}  // namespace type21
