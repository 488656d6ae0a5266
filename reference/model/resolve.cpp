#include "reference/model/resolve.h"

#include <fmt/format.h>

#include "reference/model/model.h"
#include "reference/model/numbers.h"
#include "reference/model/reading.h"
#include "reference/model/resolve_interfaces.h"

namespace type21 {

namespace {

Problem problem_at(const Reading& reading, const Card& card, Severity severity) {
    Problem problem;
    problem.severity = severity;
    problem.place = reading.deck.place(card);
    problem.card = keyword_without_ids(card);
    return problem;
}

/// Notes the id of a card that is not supported, so that a reference to it is not reported as unknown too.
void note_unsupported(Reading& reading, const Card& card) {
    const std::pair<std::string_view, Registry*> kinds[] = {
        {"MAT", &reading.materials},          {"PROP", &reading.properties},
        {"SURF", &reading.surfaces},          {"GRNOD", &reading.groups},
        {"FUNCT", &reading.functions},        {"SENSOR", &reading.sensors},
        {"RBODY", &reading.rigid_bodies},     {"INTER", &reading.interfaces},
        {"FUNCT_SMOOTH", &reading.functions}, {"FRICTION", &reading.friction_models}};
    for (const auto& [word, registry] : kinds) {
        if (card.words[0] != word) continue;
        for (const std::string& text : card.words) {
            Id id = 0;
            if (parse_integer(text, id) != NumberFault::none) continue;
            registry->unsupported.insert(id);
            break;  // a second number is a unit_ID
        }
    }
}

}  // namespace

void check_keywords(Reading& reading) {
    for (const ReadCard& entry : reading.cards) {
        const Card& card = *entry.card;
        if (card.words.empty() || entry.match.keyword == Keyword::unsupported) {
            Problem problem = problem_at(reading, card, Severity::error);
            problem.rule = "this keyword is not supported and may change the physics";
            problem.remedy = "Remove the card, or model the effect otherwise";
            reading.problems.add(problem);
            if (!card.words.empty()) note_unsupported(reading, card);
        } else if (entry.match.keyword == Keyword::output) {
            Problem problem = problem_at(reading, card, Severity::warning);
            problem.rule = "this keyword steers output that is not written here; it is ignored";
            problem.remedy = "Nothing needs to be done";
            reading.problems.add(problem);
        } else if (entry.match.keyword == Keyword::analysis) {
            CardReader reader(reading.deck, card, reading.model.units, reading.model.units, reading.problems);
            refuse_unless_zero(reader, 0, 1, 10, "N2D3D", "two-dimensional analysis is");
        }
    }
}

Model resolve(const Deck& deck, const AsBuilt& as_built, Problems& problems) {
    Model model;
    model.as_built = as_built;
    if (!deck.files.empty()) model.deck_path = deck.files.front();
    if (deck.starter.empty()) return model;  // reading the deck has said why
    Reading reading(deck, model, problems);
    read_begin(reading);
    check_keywords(reading);
    read_functions(reading);
    read_materials(reading);
    read_heat_materials(reading);
    read_mesh(reading);
    read_surfaces(reading);
    read_groups(reading);
    read_conditions(reading);
    read_loads(reading);
    read_temperatures(reading);
    read_friction(reading);
    sum_nodal_mass(model);
    sum_nodal_heat_capacity(model);
    read_rigid_bodies(reading);
    resolve_interfaces(deck, model, problems);
    read_histories(reading);
    read_engine(reading);
    return model;
}

}  // namespace type21
