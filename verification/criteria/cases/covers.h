/// @file The vocabulary of `covers` in case.toml: what of the page, and which departure, a case shows.
#pragma once

#include <string_view>

namespace type21 {

constexpr int page_equations = 20;
/// As the page's own footnotes count: Inacti refers to 9, Invn to 21, Dcond to 23; one more follows it.
constexpr int page_comments = 24;

/// "eq 5", "field DEPTH", "comment 4" or "departure D03", each of something that exists.
bool is_cover(std::string_view text);

}  // namespace type21
