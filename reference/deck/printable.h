/// @file Text of a deck as it may be shown: nothing in it steers a terminal.
#pragma once

#include <string>
#include <string_view>

namespace type21 {

/// The text with every control character written out, as in "\x1b[31m" or "\n": those of ASCII, those of the second
/// control block (U+0080 to U+009F) and the ones that turn the direction of writing. A byte that is no UTF-8 is written
/// out too. Everything else, umlauts and CJK included, stays.
std::string printable(std::string_view text);

/// printable() of at most this many characters; what is left out is counted: "abc ... (2000 characters)".
std::string printable(std::string_view text, std::size_t most);

}  // namespace type21
