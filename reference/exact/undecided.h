/// @file Thrown by a number that only encloses its value, when a comparison has no certain answer.
#pragma once

namespace type21::reference {

/// The enclosures of two compared numbers overlap, or a divisor may be zero: the next stage has to decide.
struct Undecided {};

}  // namespace type21::reference
