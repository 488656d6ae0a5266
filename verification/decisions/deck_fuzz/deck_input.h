/// @file One input of the deck fuzzer: the files of a deck in one text, read and resolved as far as a run would go.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/contract/departures.h"
#include "reference/deck/deck.h"

namespace type21::fuzz {

/// A line that begins with this mark starts another file of the deck; the rest of the line is its path.
inline constexpr std::string_view file_mark = "//// ";

/// The text up to the first mark is the starter deck fuzz_0000.rad.
std::vector<MemoryFile> deck_files(std::string_view text);

struct Reading {
    bool accepted = false;  ///< the deck has no error
    size_t length = 0;      ///< of all printed text, so that the compiler cannot leave it out
};

/// All that a run does before its first cycle and that `type21 check` prints: read, resolve, plan, check, every message
/// and every field as text.
/// @throws std::logic_error when a model without an error contains an index out of range or a number that is not finite
Reading read_and_resolve(std::string_view text, const AsBuilt& departures);

}  // namespace type21::fuzz
