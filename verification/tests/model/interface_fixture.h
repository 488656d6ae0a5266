/// @file A small scene for the tests of the TYPE21 card: a blank of four quads over a tool of one.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "reference/deck/deck.h"
#include "reference/model/model.h"

namespace type21::test {

/// Field name -> text, placed right-justified in the field's columns.
using Fields = std::map<std::string, std::string>;

/// The twelve lines with surf_IDs 1, surf_IDm 2, IDrby 5 unless given; blank else.
std::vector<std::string> card_lines(const Fields& fields);

/// Keyword, title and the twelve lines.
std::string card_text(const Fields& fields, const std::string& keyword = "/INTER/TYPE21/1");

/// A deck of this text between /BEGIN and /END, read from a file of its own. Fails the test if the text itself has
/// problems.
Deck deck_of(const std::string& cards);

/// Blank: nodes 1001..1009 on a grid x, y in {0, 10, 20} at z = 0, row by row; quads 1, 2 (y < 10) and 3, 4 (y > 10).
///   quads 1 and 3 (x < 10): part 0, 1.0 mm; quads 2 and 4: part 1, 1.4 mm; E = 200000 MPa
/// Tool: nodes 2001..2004, a quad of part 2 (void, 7 mm) from (-5, -5) to (25, 25) at z = -2 that looks to +z; main
/// node 3001 of rigid body 5. Surface 1: blank, surface 2: tool. Units Mg mm s. Nodal mass: 0.001 * (rank + 1).
Model blank_over_tool();

/// The same with a heat capacity at every node of both sides (0.5 mJ/K) and functions 3 (constant 2) and 4 (from 1 at 0
/// to 0 at 1).
Model thermal_blank_over_tool();

/// The interface of one card in this model; its problems in `problems`.
Interface resolve_card(Model& model, const std::string& text, Problems& problems);
Interface resolve_fields(Model& model, const Fields& fields, Problems& problems);

/// The problems of this field ("" = any) and severity.
std::vector<Problem> about(const Problems& problems, const std::string& field, Severity severity);

}  // namespace type21::test
