/// @file The words of `covers` in case.toml: what of the manual page, and which departure, a case shows.
#pragma once

#include <string_view>

namespace type21 {

constexpr int manual_equations = 20;
/// As the footnotes of the manual page count: Inacti refers to 9, Invn to 21, Dcond to 23; one more follows it.
constexpr int manual_comments = 24;

/// "eq 5", "field DEPTH", "comment 4" or "departure D03", where such an equation, field, comment or departure exists.
bool is_cover(std::string_view text);

}  // namespace type21
