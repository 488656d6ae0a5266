/// @file Quads that repeat a node: triangles in other spellings.
#pragma once

#include <array>
#include <string_view>

#include "reference/model/card_reader.h"

namespace type21 {

/// Brings the spellings of a triangle to the one that the model knows, in which the fourth node repeats the third. The
/// order around the triangle stays.
///   n4 = 0: n1 n2 n3 n3      n1 = n2: n2 n3 n4 n4      n2 = n3: n1 n2 n4 n4      n4 = n1: n1 n2 n3 n3
/// The last three are a warning, once for a card with their count. Four nodes that are neither a quad nor a triangle
/// are an error.
/// @param line   data line of the card
/// @param nodes  node ids as written; mended afterwards
/// @param kind   "shell" or "segment", for the messages
/// @param id     of the quad, for the error; 0 where it has none
/// @return false after an error
bool mend_quad(CardReader& reader, size_t line, std::array<Id, 4>& nodes, std::string_view kind, Id id);

}  // namespace type21
