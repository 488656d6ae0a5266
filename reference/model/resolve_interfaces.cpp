/// @file Every TYPE21 card in turn: read, checked, linked, defaults, both sides.
#include "reference/model/resolve_interfaces.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "reference/model/heat_rules.h"
#include "reference/model/interface_defaults.h"
#include "reference/model/interface_links.h"
#include "reference/model/interface_rules.h"
#include "reference/model/main_normals.h"
#include "reference/model/nodal_gaps.h"
#include "reference/model/read_interface_card.h"
#include "reference/model/repeated_segments.h"
#include "reference/model/secondary_side.h"
#include "reference/model/tool_side.h"

namespace type21 {
namespace {

/// A card that was read, and its interface; IDref waits for the others.
struct PendingCard {
    CardReader card;
    size_t interface = 0;
};

bool is_type21(const Card& card) {
    return card.words.size() >= 2 && card.words[0] == "INTER" && card.words[1] == "TYPE21";
}

/// inter_ID of the keyword, 0 if there is none.
Id interface_id(CardReader& reader, const Card& card) {
    const std::string word = card.words.size() > 2 ? card.words[2] : "";
    Id id = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), id);
    if (error == std::errc{} && end == word.data() + word.size() && id > 0) return id;
    reader.error(-1, "inter_ID", word, "the keyword names the interface by a positive number",
                 "Write /INTER/TYPE21/1, with an id of its own");
    return 0;
}

bool has_segments(const Model& model, int surface) {
    return surface >= 0 && !model.surfaces[static_cast<size_t>(surface)].segments.empty();
}

/// Everything of time 0 that needs both surfaces and the tool.
void build_sides(const CardValidator& validator) {
    const Interface& it = validator.interface;
    if (!has_segments(validator.model, it.secondary_surface)) return;
    build_secondary_side(validator);
    resolve_gaps(validator);
    resolve_heat_distances(validator);
    if (!has_segments(validator.model, it.main_surface) || it.tool < 0) return;
    build_tool_side(validator);
    check_sides(validator);
    check_thermal_sides(validator);
    check_main_normals(validator);
}

}  // namespace

void resolve_interfaces(const Deck& deck, Model& model, Problems& problems) {
    constexpr size_t unit_word = 3;
    std::vector<PendingCard> cards;
    for (const Card& card : deck.starter) {
        if (!is_type21(card)) continue;
        CardReader reader(deck, card, card_units(deck, card, unit_word, model, problems), model.units, problems);
        Interface interface;
        interface.id = interface_id(reader, card);
        interface.title = reader.text(0, 1, 100);
        interface.file = reader.file();
        interface.line = card.place.number;
        if (interface.id != 0 && std::any_of(model.interfaces.begin(), model.interfaces.end(),
                                             [&](const Interface& other) { return other.id == interface.id; }))
            reader.error(-1, "inter_ID", fmt::format("{}", interface.id), "is the id of another interface already",
                         "Give each interface an id of its own");
        if (read_interface_card(reader, model.version, interface)) {
            const CardValidator validator{reader, model, interface};
            check_interface_card(validator);
            link_interface(validator);
            apply_interface_defaults(validator);
            note_repeated_segments(validator, model);
            build_sides(validator);
            cards.push_back({reader, model.interfaces.size()});
        }
        model.interfaces.push_back(std::move(interface));
    }
    for (PendingCard& read : cards)
        link_reference_interface({read.card, model, model.interfaces[read.interface]});
}

}  // namespace type21
