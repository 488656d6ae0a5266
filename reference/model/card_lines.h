/// @file The data lines that a card must have.
#pragma once

#include <string_view>
#include <vector>

#include "reference/model/known_keywords.h"

namespace type21 {

/// Data lines from the title on that a card of this keyword has at least, each named by its fields. Empty where every
/// line may be left out. A deck that has lost the last line of a card would otherwise be read with defaults.
const std::vector<std::string_view>& needed_lines(Keyword keyword);

}  // namespace type21
