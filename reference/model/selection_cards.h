/// @file The cards that select something (groups, surfaces, boxes, subsets, sets), found by kind and id. Nothing is
/// read here: a card that no other one names costs a row in a table.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "reference/contract/mesh.h"
#include "reference/deck/deck.h"

namespace type21 {

struct Reading;

/// What a card selects. Ids count within a family.
enum class Family { box, subset, part_group, shell_group, sh3n_group, node_group, surface, set };
inline constexpr std::size_t family_count = 8;

/// "/GRNOD" for Family::node_group, and so on.
std::string_view keyword_of(Family family);

/// "grnod_ID": the field by which others name a card of this family.
std::string_view field_of(Family family);

struct SelectionCard {
    const Card* card = nullptr;
    Family family = Family::box;
    Id id = 0;
    std::string type;           ///< second word of the keyword: "PART", "BOX2"; empty for /SUBSET
    std::size_t unit_word = 0;  ///< position of the unit_ID in the keyword
};

/// All of them, in the order of the deck.
class SelectionCards {
  public:
    /// A card without an id, or with one that another card of its family has, is an error and is left out.
    explicit SelectionCards(Reading& reading);

    /// The card of this family; for groups and surfaces the /SET with this id when there is none. nullptr if neither.
    const SelectionCard* find(Family family, Id id) const;

    /// A group or surface and a /SET have this id, so that it names two things.
    bool ambiguous(Family family, Id id) const;

    const std::vector<SelectionCard>& all() const { return cards_; }

  private:
    std::vector<SelectionCard> cards_;
    std::array<std::unordered_map<Id, std::size_t>, family_count> by_id_;  ///< index into cards_
};

}  // namespace type21
