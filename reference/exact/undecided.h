/// @file What a number that only encloses its value throws when it is asked for an answer that it cannot give.
#pragma once

namespace type21::reference {

/// The enclosures of two compared numbers overlap: the next stage has to decide.
struct Undecided {};

}  // namespace type21::reference
