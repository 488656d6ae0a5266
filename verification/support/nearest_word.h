/// @file The word that was probably meant.
#pragma once

#include <string_view>
#include <vector>

namespace type21 {

/// The word of a list that takes the fewest changes of one character; empty where even that is another word (more
/// than a third of the characters change).
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& words);

}  // namespace type21
