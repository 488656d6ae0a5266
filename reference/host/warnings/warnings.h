/// @file What a deck says and its author most likely does not mean. None of it stops a run; each is said once, with a
/// count, one place and a remedy.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/deck/deck.h"
#include "reference/deck/problem.h"
#include "reference/model/model.h"

namespace type21 {

/// Adds the warnings of a deck without errors. Fields that have their default value give none.
/// @param deck   the text of the model, for the lines of its cards
/// @param model  complete: resolved without an error
void warn_of_surprises(const Deck& deck, const Model& model, Problems& problems);

/// What every check of this folder is given.
struct SurpriseCheck {
    const Deck& deck;
    const Model& model;
    Problems& problems;

    /// A warning at the card "/KEYWORD.../id".
    void at_card(std::string_view keyword, Id id, std::string_view field, std::string value, std::string rule,
                 std::string remedy) const;
    /// A warning at an interface.
    void at_interface(const Interface& interface, std::string_view field, std::string value, std::string rule,
                      std::string remedy) const;

    const Surface& main_surface(const Interface& interface) const;
    const Surface& secondary_surface(const Interface& interface) const;
    /// "4, 7, 9, 10": the nodes of a segment by id, a triangle with three.
    std::string nodes_of(const Segment& segment) const;
    /// A value with its unit.
    std::string quantity(double value, Dimension dimension) const;
};

// The checks, one concept a file.
void warn_of_turned_segments(const SurpriseCheck& check);
void warn_of_open_seams(const SurpriseCheck& check);
void warn_of_thin_tools(const SurpriseCheck& check);
void warn_of_long_steps(const SurpriseCheck& check);
void warn_of_fine_tools(const SurpriseCheck& check);
void warn_of_ending_functions(const SurpriseCheck& check);
void warn_of_two_drives(const SurpriseCheck& check);
void warn_of_same_pairs(const SurpriseCheck& check);
void warn_of_void_blanks(const SurpriseCheck& check);
void warn_of_far_coordinates(const SurpriseCheck& check);
void warn_of_implausible_values(const SurpriseCheck& check);

}  // namespace type21
