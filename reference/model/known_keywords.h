/// @file The keywords that the starter deck may hold, and what becomes of the others.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "reference/deck/deck.h"

namespace type21 {

enum class Keyword {
    begin,
    unit,
    title,
    node,
    shell,
    sh3n,
    part,
    property_shell,
    property_void,
    material_elastic,
    material_johnson_cook,
    material_void,
    material_heat,
    selection,  ///< groups, surfaces, boxes, subsets and sets: read when a card names one
    transform,
    rigid_body,
    boundary_condition,
    imposed_velocity,
    imposed_displacement,
    imposed_acceleration,
    initial_translation,
    initial_rotation,
    initial_axis,
    gravity,
    added_mass_each,
    added_mass_shared,
    initial_temperature,
    imposed_temperature,
    load,
    function,
    move_function,
    skew_fixed,
    frame_fixed,
    sensor,
    friction,
    interface,
    history_interface,
    history_node,
    history_rigid_body,
    analysis,
    random,           ///< moves nodes at random unless its amplitude is 0
    harmless,         ///< neither physics nor output
    output,           ///< steers only output that is not written or element formulations: one warning for all
    definition,       ///< harmless until something refers to it
    element,          ///< belongs to elements whose forces are not computed: an error
    other_interface,  ///< a contact that is not TYPE21: an error
    unsupported       ///< would change the physics: an error
};

/// A keyword and how many of the card's words name it; the next word is the id, the one after it the unit_ID.
struct KeywordMatch {
    Keyword keyword = Keyword::unsupported;
    std::size_t words = 1;
};

/// The longest known keyword that the card's words begin with.
KeywordMatch match(const Card& card);

/// "/MAT/ELAST" of "/MAT/ELAST/3/1": the keyword without its ids.
std::string keyword_without_ids(const Card& card);

}  // namespace type21
