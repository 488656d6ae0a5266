#include "verification/results/tables/csv_number.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace type21 {
namespace {

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// 1,234 or 12,345,678: a decimal comma, or commas between thousands?
bool could_be_thousands(std::string_view text) {
    if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
    const size_t comma = text.find(',');
    const std::string_view before = text.substr(0, comma), after = text.substr(comma + 1);
    return !before.empty() && before.size() <= 3 && before[0] != '0' && after.size() == 3 &&
           std::all_of(before.begin(), before.end(), is_digit) && std::all_of(after.begin(), after.end(), is_digit);
}

/// Of a number that std::from_chars found to be out of range.
bool is_tiny(std::string_view text) {
    const size_t exponent = text.find_first_of("eE");
    if (exponent != std::string_view::npos) return text.substr(exponent + 1).starts_with('-');
    return text.starts_with("0") || text.starts_with("-0") || text.starts_with(".") || text.starts_with("-.");
}

}  // namespace

std::optional<double> CsvNumbers::read(std::string_view cell, size_t line) {
    char copy[64];
    std::string_view text = cell;
    if (text.starts_with('+')) text.remove_prefix(1);
    if (text.find_first_of("dD,") != std::string_view::npos) {
        if (text.size() >= sizeof copy) return std::nullopt;
        const bool comma = decimal_comma_ && std::count(text.begin(), text.end(), ',') == 1 &&
                           text.find('.') == std::string_view::npos;
        if (comma) {
            if (comma_line_ == 0) comma_line_ = line;
            comma_is_clear_ = comma_is_clear_ || !could_be_thousands(text);
        }
        std::transform(text.begin(), text.end(), copy, [&](char c) {
            if (c == 'd' || c == 'D') return 'e';
            return c == ',' && comma ? '.' : c;
        });
        text = {copy, text.size()};
    } else if (point_line_ == 0 && text.find('.') != std::string_view::npos) {
        point_line_ = line;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || end != text.data() + text.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range) return is_tiny(text) ? std::optional(0.0) : std::nullopt;
    if (error != std::errc{}) return std::nullopt;
    return value;
}

std::optional<double> CsvNumbers::read_value(std::string_view cell, size_t line) {
    const std::optional<double> value = read(cell, line);
    if (value && *value != 0 && std::isfinite(*value)) count_digits(cell);
    return value;
}

void CsvNumbers::count_digits(std::string_view cell) {
    int digits = 0;
    size_t i = 0;
    for (; i < cell.size() && std::isalpha(static_cast<unsigned char>(cell[i])) == 0; ++i)
        if (is_digit(cell[i]) && (digits > 0 || cell[i] != '0')) ++digits;
    all_scientific_ = all_scientific_ && i < cell.size();
    ++values_;
    fewest_digits_ = std::min(fewest_digits_, digits);
    if (digits > most_digits_) with_most_ = 0;
    most_digits_ = std::max(most_digits_, digits);
    if (digits == most_digits_) ++with_most_;
}

std::string CsvNumbers::fault() const {
    if (comma_line_ == 0) return "";
    if (point_line_ > 0)
        return fmt::format("decimal points (line {}) beside commas in numbers (line {}); use one of them", point_line_,
                           comma_line_);
    if (!comma_is_clear_)
        return fmt::format(
            "it cannot be told whether the commas in numbers (line {}) are decimal commas or stand "
            "between thousands; write decimal points",
            comma_line_);
    return "";
}

int CsvNumbers::printed_digits() const {
    if (most_digits_ < 4 || most_digits_ > 14) return 0;
    // %.6e gives every number the same digits. %.7g leaves out zeros at the end, in one of ten numbers; a short table
    // of exact numbers looks alike, so that form must show often.
    const bool fixed = all_scientific_ && fewest_digits_ == most_digits_ && most_digits_ >= 6;
    const bool often = values_ >= 20 && 2 * with_most_ >= values_;
    return fixed || often ? most_digits_ : 0;
}

}  // namespace type21
