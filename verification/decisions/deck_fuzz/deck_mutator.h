/// @file Changes that keep a deck a deck: whole lines, whole fields, numbers at the border of what a number can be.
#pragma once

#include <cstdint>
#include <string>

namespace type21::fuzz {

/// One or a few changes of lines or fields of `text`, all decided by `seed`.
std::string mutated(std::string text, std::uint32_t seed);

}  // namespace type21::fuzz
