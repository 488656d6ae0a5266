#include "reference/model/selection_cards.h"

#include <optional>

#include <fmt/format.h>

#include "reference/model/numbers.h"
#include "reference/model/reading.h"

namespace type21 {

namespace {

struct FamilyName {
    std::string_view word, keyword, field;
};

constexpr std::array<FamilyName, family_count> names{{{"BOX", "/BOX", "box_ID"},
                                                      {"SUBSET", "/SUBSET", "subset_ID"},
                                                      {"GRPART", "/GRPART", "grpart_ID"},
                                                      {"GRSHEL", "/GRSHEL", "grshel_ID"},
                                                      {"GRSH3N", "/GRSH3N", "grsh3n_ID"},
                                                      {"GRNOD", "/GRNOD", "grnod_ID"},
                                                      {"SURF", "/SURF", "surf_ID"},
                                                      {"SET", "/SET", "set_ID"}}};

std::optional<Family> family_of(const Card& card) {
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!card.words.empty() && card.words[0] == names[i].word) return static_cast<Family>(i);
    }
    return std::nullopt;
}

/// Position of the id: the first word behind the keyword that is a number. "/SURF/PART/EXT/9" has it in word 3.
std::size_t id_word(const Card& card) {
    for (std::size_t i = 1; i < card.words.size(); ++i) {
        Id id = 0;
        if (parse_integer(card.words[i], id) == NumberFault::none) return i;
    }
    return card.words.size();
}

/// Another card may stand for one of these: a /SET is nodes, shells, parts and segments.
bool may_be_set(Family family) {
    return family != Family::box && family != Family::subset && family != Family::set;
}

}  // namespace

std::string_view keyword_of(Family family) {
    return names[static_cast<std::size_t>(family)].keyword;
}

std::string_view field_of(Family family) {
    return names[static_cast<std::size_t>(family)].field;
}

SelectionCards::SelectionCards(Reading& reading) {
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword != Keyword::selection) continue;
        const std::optional<Family> family = family_of(*entry.card);
        if (!family) continue;
        SelectionCard found;
        found.card = entry.card;
        found.family = *family;
        const std::size_t word = id_word(*entry.card);
        found.unit_word = word + 1;
        if (word > 1) found.type = entry.card->words[1];
        CardReader reader(reading.deck, *entry.card, reading.model.input_units, reading.model.units, reading.problems);
        const std::optional<Id> id = id_of(*entry.card, word, reader);
        if (!id) continue;
        found.id = *id;
        const auto [known, is_new] = by_id_[static_cast<std::size_t>(*family)].emplace(*id, cards_.size());
        if (!is_new) {
            const Place first = reading.deck.place(*cards_[known->second].card);
            reader.error(-1, "id", fmt::format("{}", *id),
                         fmt::format("the id is taken by the card at {}:{}", first.file, first.line),
                         "Give each its own id, or remove one");
            continue;
        }
        cards_.push_back(std::move(found));
    }
}

const SelectionCard* SelectionCards::find(Family family, Id id) const {
    const auto& own = by_id_[static_cast<std::size_t>(family)];
    if (const auto found = own.find(id); found != own.end()) return &cards_[found->second];
    return may_be_set(family) ? find(Family::set, id) : nullptr;
}

bool SelectionCards::ambiguous(Family family, Id id) const {
    return may_be_set(family) && by_id_[static_cast<std::size_t>(family)].count(id) > 0 &&
           by_id_[static_cast<std::size_t>(Family::set)].count(id) > 0;
}

}  // namespace type21
