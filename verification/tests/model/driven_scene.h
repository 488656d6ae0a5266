/// @file The text of a small valid deck, and pieces of it to spoil.
#pragma once

#include <string>
#include <vector>

#include "reference/model/model.h"
#include "verification/tests/deck/problem_search.h"

namespace type21::test {

/// A blank of one quad and one triangle (nodes 1 to 5, part 1, fixed) over a tool of one quad (nodes 101 to 104, part
/// 2, void) that is driven down through its main node 201. Mg mm s, version 2025.
std::string driven_scene();

/// Its engine deck.
std::string driven_engine();

/// The cards (each a keyword line and data lines) put before /END of driven_scene().
std::string with_cards(const std::string& cards);

/// What reading and resolving this text gives.
struct Resolved {
    Model model;
    Problems problems;
};
Resolved resolved(const std::string& starter, const std::string& engine = driven_engine());

/// Data lines: each field right-justified in its width.
std::string ints(const std::vector<std::string>& fields);
std::string reals(const std::vector<std::string>& fields);

/// The only problem of the deck; fails the test when there are none or several.
Problem only(const Problems& problems);

}  // namespace type21::test
