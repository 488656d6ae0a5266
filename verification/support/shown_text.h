/// @file Text from a file that the program did not make, as a message may quote it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace type21 {

/// A quotation in a message is no longer than this [character].
inline constexpr std::size_t shown_length = 60;

/// Bytes that a terminal obeys instead of showing, and bytes that are not UTF-8, are written \x1b; what is longer than
/// `limit` is cut and ends in "...". Always valid UTF-8.
std::string shown(std::string_view text, std::size_t limit = shown_length);

}  // namespace type21
