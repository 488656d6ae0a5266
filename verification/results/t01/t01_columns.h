/// @file What the variable codes of a time-history file mean.
#pragma once

#include <string_view>

namespace type21 {

/// Name of a /TH/INTER variable that a contact of TYPE21 fills, as a column of interface_<id>.csv: codes 1 to 6, 8 to
/// 15 and 25 to 28. Empty for the others.
std::string_view interface_variable(int code);

/// Name of a /TH/NODE variable, as a column of nodes.csv. Empty for a code whose meaning was not derived.
///
/// No list of these codes was at hand: they were derived from two measured files, whose decks say in which order the
/// variables are asked for, and from the histories of the same runs as text. cases/flat_press asks for DX .. DZ,
/// VX .. VZ, VRX .. VRZ, REACX .. REACZ and its file has 1 .. 6, 10 .. 12, 620 .. 622; DZ, VZ and the reactions are not
/// zero there, and each value is that of the text to the last bit. The sheet of verification/tests/results/t01/data
/// asks for DEF and A, and its file has 1 .. 9: D, V, A. A test reads both files again.
std::string_view node_variable(int code);

}  // namespace type21
