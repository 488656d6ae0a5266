/// @file One card under judgement: what its rules may see, change and say.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/model/card_reader.h"
#include "reference/model/model.h"

namespace type21 {

struct CardValidator {
    CardReader& card;
    const Model& model;
    Interface& interface;

    /// Says it at the field's line, with its value and unit as read.
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
