/// @file Words of a deck as numbers, and what is wrong with those that are none.
#pragma once

#include <cstdint>
#include <string_view>

namespace type21 {

/// Why a word is not the number asked for.
enum class NumberFault { none, not_a_number, not_an_integer, out_of_range };

/// A decimal integer of 64 bits; "1.0" is not_an_integer. `value` is set only without a fault.
NumberFault parse_integer(std::string_view word, std::int64_t& value);

/// A finite decimal real; a Fortran exponent (1.5D-3) is read, NaN and infinity are not numbers.
NumberFault parse_real(std::string_view word, double& value);

}  // namespace type21
