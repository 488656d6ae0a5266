/// @file The characters of a text in UTF-8, one after the other.
#pragma once

#include <cstddef>
#include <string_view>

namespace type21 {

/// One character of a text. A byte that begins none is one that is not valid.
struct Utf8Character {
    std::size_t bytes = 1;
    char32_t code = 0;
    bool valid = false;
};

/// The character at the beginning of a text that is not empty. Longer forms than needed, halves of a pair of UTF-16 and
/// codes above U+10FFFF are not valid.
Utf8Character first_character(std::string_view text);

}  // namespace type21
