/// @file An account: lines with a formula, its numbers and its value, printed as text or JSON.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "reference/contract/vector.h"

namespace type21 {

/// "F = k p = 252000 x 0.0123 = 3099.6 N   manual page, equation (5)". Missing parts are empty.
struct AccountLine {
    std::string symbol;
    std::string formula;  ///< in symbols
    std::string numbers;  ///< the same with numbers
    std::variant<std::monostate, double, Vec3, std::string> value;
    std::string unit;
    std::string source;
};

struct AccountSection {
    std::string title;
    std::vector<AccountLine> lines;

    void add(std::string symbol, std::string formula, std::string numbers, double value, std::string unit,
             std::string source) {
        lines.push_back(
            {std::move(symbol), std::move(formula), std::move(numbers), value, std::move(unit), std::move(source)});
    }
    void add(std::string symbol, std::string formula, std::string numbers, const Vec3& value, std::string unit,
             std::string source) {
        lines.push_back(
            {std::move(symbol), std::move(formula), std::move(numbers), value, std::move(unit), std::move(source)});
    }
    /// A line in words.
    void say(std::string symbol, std::string words, std::string source = "") {
        lines.push_back({std::move(symbol), "", "", std::move(words), "", std::move(source)});
    }
};

}  // namespace type21
