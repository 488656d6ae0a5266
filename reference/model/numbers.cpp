#include "reference/model/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace type21 {

namespace {

std::string_view without_plus(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    return word;
}

}  // namespace

NumberFault parse_real(std::string_view word, double& value) {
    word = without_plus(word);
    std::array<char, 64> digits{};
    if (word.empty() || word.size() > digits.size()) return NumberFault::not_a_number;
    const char first = word[0] == '-' && word.size() > 1 ? word[1] : word[0];
    if (first != '.' && (first < '0' || first > '9')) return NumberFault::not_a_number;
    char* end = digits.data();
    for (const char c : word)
        *end++ = (c == 'd' || c == 'D') ? 'e' : c;
    double read = 0;
    const auto [stop, code] = std::from_chars(digits.data(), end, read);
    if (code == std::errc::result_out_of_range) return NumberFault::out_of_range;
    if (code != std::errc() || stop != end || !std::isfinite(read)) return NumberFault::not_a_number;
    value = read;
    return NumberFault::none;
}

NumberFault parse_integer(std::string_view word, std::int64_t& value) {
    word = without_plus(word);
    std::int64_t read = 0;
    const auto [stop, code] = std::from_chars(word.data(), word.data() + word.size(), read);
    if (stop != word.data() + word.size() || code == std::errc::invalid_argument) {
        double real = 0;
        return parse_real(word, real) == NumberFault::not_a_number ? NumberFault::not_a_number
                                                                   : NumberFault::not_an_integer;
    }
    if (code == std::errc::result_out_of_range) return NumberFault::out_of_range;
    value = read;
    return NumberFault::none;
}

}  // namespace type21
