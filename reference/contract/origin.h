/// @file A value that knows where it came from.
#pragma once

#include <string>

namespace type21 {

/// Where a resolved value came from: the deck (line > 0), the default, or a rule that changed it.
struct Origin {
    enum class Kind { deck, fallback, rule, absent };
    Kind kind = Kind::absent;
    int line = 0;     ///< line of the deck, 0 if none
    std::string why;  ///< the default's or rule's own words: "default: 0 means 1", "raised to the largest gap"
};

/// A resolved value with its origin.
template <class T>
struct Sourced {
    T value{};
    Origin origin{};
    operator const T&() const { return value; }  // NOLINT: reads as the value it is
};

/// "line 41", "default: ...", "rule (line 41): ...", "not in this version".
std::string to_text(const Origin& origin);

}  // namespace type21
