#include <algorithm>
#include <set>

#include "reference/model/selector.h"

namespace type21 {

namespace {

std::string title_of(const Reading& reading, const SelectionCard& card) {
    Problems unused;
    return CardReader(reading.deck, *card.card, reading.model.units, reading.model.units, unused).text(0, 1, 100);
}

int load_group(Reading& reading, Id id) {
    int& index = reading.groups.entries.at(id).index;
    index = -1;
    const SelectionCard* card = reading.selector->cards().find(Family::node_group, id);
    if (card == nullptr) return index;
    const int before = reading.problems.error_count();
    NodeGroup group;
    group.id = id;
    group.title = title_of(reading, *card);
    group.nodes = reading.selector->nodes(*card);
    if (reading.selector->cards().ambiguous(Family::node_group, id)) {
        CardReader reader = reading.reader(*card->card, card->unit_word);
        reading.selector->find(reader, keyword_line, Family::node_group, id);
    }
    if (reading.problems.error_count() > before) return index;
    index = static_cast<int>(reading.model.groups.size());
    reading.model.groups.push_back(std::move(group));
    return index;
}

/// The surfaces that the interfaces name, in the order of the deck. The reader of the interfaces finds them by id.
void read_interface_surfaces(Reading& reading) {
    Problems told_by_the_interface;
    std::set<const SelectionCard*> wanted;  // they lie in one vector, so their order is that of the deck
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword != Keyword::interface) continue;
        CardReader reader(reading.deck, *entry.card, reading.model.units, reading.model.units, told_by_the_interface);
        for (const int column : {1, 11}) {
            const Id id = reader.integer(1, column, column + 9, "surf_ID");
            if (id == 0) continue;
            const SelectionCard* card = reading.selector->cards().find(Family::surface, id);
            if (card == nullptr) continue;
            wanted.insert(card);
            if (!reading.selector->cards().ambiguous(Family::surface, id)) continue;
            CardReader complaint = reading.reader(*entry.card, entry.match.words + 1);
            reading.selector->find(complaint, 1, Family::surface, id);
        }
    }
    for (const SelectionCard* card : wanted) {
        Surface surface;
        surface.id = card->id;
        surface.title = title_of(reading, *card);
        surface.segments = reading.selector->segments(*card);
        reading.model.surfaces.push_back(std::move(surface));
    }
}

}  // namespace

/// /GRNOD, /GRSHEL, /GRSH3N, /GRPART, /SURF, /BOX, /SUBSET and /SET. A card that nothing names is not read: it costs
/// nothing and does no harm, whatever its kind. /TRANSFORM comes first; its groups are given by ids, not by boxes.
void read_selections(Reading& reading) {
    reading.selector = std::make_unique<Selector>(reading);
    for (const SelectionCard& card : reading.selector->cards().all()) {
        if (card.family == Family::node_group || card.family == Family::set)
            reading.groups.entries.emplace(card.id,
                                           Registry::Entry{Registry::not_loaded, reading.deck.place(*card.card)});
    }
    reading.groups.load = [&reading](Id id) { return load_group(reading, id); };
    read_transforms(reading);
    reading.selector->place_nodes();
    read_interface_surfaces(reading);
}

}  // namespace type21
