/// @file Where the starter cards hold ids, and of what: what a //SUBMODEL needs to move the ids of its cards.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "reference/deck/deck.h"

namespace type21 {

/// What an id names. A //SUBMODEL has an offset for each.
enum class IdKind { other, node, element, part, material, property };
inline constexpr std::size_t id_kinds = 6;

/// An id of ten columns.
struct IdField {
    std::size_t line = 0;  ///< data line of the card
    int first = 1;         ///< first column
    IdKind kind = IdKind::other;
};

/// What the number behind the keyword names; false for a card without one (/NODE).
bool has_id(const Card& card);
IdKind kind_of_keyword(const Card& card);

/// All fields of the card that hold ids, blank ones too.
/// @return false for a card whose ids are not known here
bool id_fields(const Card& card, std::vector<IdField>& fields);

}  // namespace type21
