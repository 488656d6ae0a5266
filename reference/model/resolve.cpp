#include "reference/model/resolve.h"

#include <map>

#include <fmt/format.h>

#include "reference/model/model.h"
#include "reference/model/numbers.h"
#include "reference/model/reading.h"
#include "reference/model/resolve_interfaces.h"
#include "reference/model/selector.h"

namespace type21 {

namespace {

Problem problem_at(const Reading& reading, const Card& card, Severity severity) {
    Problem problem;
    problem.severity = severity;
    problem.place = reading.deck.place(card);
    problem.card = keyword_without_ids(card);
    return problem;
}

/// Notes the id of a card that is not read. One that was refused has had its message, so that a reference to it has
/// none; any other is an error as soon as something refers to it.
void note_id(Reading& reading, const Card& card, bool refused) {
    const std::pair<std::string_view, Registry*> kinds[] = {
        {"MAT", &reading.materials},          {"PROP", &reading.properties},         {"FUNCT", &reading.functions},
        {"SENSOR", &reading.sensors},         {"RBODY", &reading.rigid_bodies},      {"INTER", &reading.interfaces},
        {"FUNCT_SMOOTH", &reading.functions}, {"FRICTION", &reading.friction_models}};
    for (const auto& [word, registry] : kinds) {
        if (card.words[0] != word) continue;
        for (const std::string& text : card.words) {
            Id id = 0;
            if (parse_integer(text, id) != NumberFault::none) continue;
            if (refused) {
                registry->unsupported.insert(id);
            } else {
                registry->unread.emplace(id, card.keyword);
            }
            break;  // a second number is a unit_ID
        }
    }
}

}  // namespace

namespace {

struct Refusal {
    const char* rule;
    const char* remedy;
};

Refusal refusal(Keyword keyword) {
    if (keyword == Keyword::element)
        return {
            "not supported yet: it belongs to elements that deform, and element forces are not computed",
            "Drive the nodes of the blank (/BCS, /IMPVEL, /IMPDISP) and give its part /MAT/ELAST, /MAT/PLAS_JOHNS or "
            "/MAT/VOID and /PROP/SHELL or /PROP/VOID, or remove the card"};
    if (keyword == Keyword::other_interface)
        return {"only contacts of TYPE21 are computed", "Remove the card, or make it a /INTER/TYPE21"};
    return {"this keyword is not supported and may change the physics",
            "Remove the card, or model the effect otherwise"};
}

void refuse(Reading& reading, const Card& card, Keyword keyword) {
    Problem problem = problem_at(reading, card, Severity::error);
    problem.rule = refusal(keyword).rule;
    problem.remedy = refusal(keyword).remedy;
    reading.problems.add(problem);
    if (!card.words.empty()) note_id(reading, card, true);
}

/// /RANDOM with an amplitude moves nodes; without one it does nothing.
void check_random(Reading& reading, const Card& card) {
    CardReader reader(reading.deck, card, reading.model.input_units, reading.model.units, reading.problems);
    const double amplitude = reader.real(0, 1, 20, "Xalea", dim::length);
    reader.unused(0, 21, 40, 20);
    reader.finish();
    if (amplitude != 0)
        reader.error(0, "Xalea", quantity(reader, amplitude, dim::length), "nodes are not moved at random here",
                     "Set it to 0, or move the nodes in the deck");
}

}  // namespace

void check_keywords(Reading& reading) {
    for (const ReadCard& entry : reading.cards) {
        const Card& card = *entry.card;
        const Keyword keyword = entry.match.keyword;
        if (card.words.empty() || keyword == Keyword::unsupported || keyword == Keyword::element ||
            keyword == Keyword::other_interface) {
            refuse(reading, card, keyword);
        } else if (keyword == Keyword::output) {
            reading.ignore(card);
        } else if (keyword == Keyword::definition) {
            note_id(reading, card, false);
        } else if (keyword == Keyword::random) {
            check_random(reading, card);
        } else if (keyword == Keyword::analysis) {
            CardReader reader(reading.deck, card, reading.model.units, reading.model.units, reading.problems);
            refuse_unless_zero(reader, 0, 1, 10, "N2D3D", "two-dimensional analysis is");
        }
    }
}

void check_interfaces(const Deck& deck, const Model& model, Problems& problems) {
    std::map<std::string, int> others;
    for (const Card& card : deck.starter) {
        if (card.words.size() < 2 || card.words[0] != "INTER") continue;
        if (card.words[1] == "TYPE21") return;
        if (card.words[1] == "SUB") continue;  // output of a part of another
        ++others["/INTER/" + card.words[1]];
    }
    std::string list;
    for (const auto& [keyword, count] : others)
        list += fmt::format("{}{}{}", list.empty() ? "" : ", ", keyword, count > 1 ? fmt::format(" ({})", count) : "");
    Problem problem;
    problem.place.file = model.deck_path;
    problem.card = "/INTER/TYPE21";
    problem.rule = list.empty() ? "the deck has no such card, so there is no contact to compute"
                                : "the deck has no such card, only " + list;
    problem.remedy = "Give the deck of a stamping contact: a blank, a tool and /INTER/TYPE21 between them";
    problems.add(problem);
}

namespace {

/// @param own  the same deck when its mesh lines may be forgotten, else nullptr
Model resolve_deck(const Deck& deck, Deck* own, const AsBuilt& as_built, Problems& problems) {
    Model model;
    model.as_built = as_built;
    if (!deck.files.empty()) model.deck_path = deck.files.front();
    if (deck.starter.empty()) return model;  // reading the deck has said why
    Reading reading(deck, model, problems);
    if (own != nullptr) {
        reading.forget = [own](std::string_view word) {
            forget_lines(*own, [word](const Card& card) { return !card.words.empty() && card.words[0] == word; });
        };
    }
    read_begin(reading);
    check_keywords(reading);
    read_skews(reading);
    read_functions(reading);
    read_sensors(reading);
    read_materials(reading);
    read_heat_materials(reading);
    read_mesh(reading);
    read_selections(reading);
    read_conditions(reading);
    read_loads(reading);
    read_temperatures(reading);
    read_friction(reading);
    sum_nodal_mass(model);
    sum_nodal_heat_capacity(model);
    read_rigid_bodies(reading);
    resolve_interfaces(deck, model, problems);
    read_histories(reading);
    link_sensors(reading);
    read_engine(reading);
    reading.selector->check_unused();
    reading.say_ignored();
    return model;
}

}  // namespace

Model resolve(const Deck& deck, const AsBuilt& as_built, Problems& problems) {
    return resolve_deck(deck, nullptr, as_built, problems);
}

Model resolve_and_forget(Deck& deck, const AsBuilt& as_built, Problems& problems) {
    return resolve_deck(deck, &deck, as_built, problems);
}

}  // namespace type21
