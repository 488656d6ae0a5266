#include "reference/host/warnings/warnings.h"

#include <utility>

#include <fmt/format.h>

#include "reference/model/numbers.h"

namespace type21 {
namespace {

bool has_id(const Card& card, Id id) {
    for (const std::string& word : card.words) {
        Id number = 0;
        if (parse_integer(word, number) == NumberFault::none) return number == id;  // a second number is a unit_ID
    }
    return false;
}

}  // namespace

void SurpriseCheck::at_card(std::string_view keyword, Id id, std::string_view field, std::string value,
                            std::string rule, std::string remedy) const {
    Problem problem{Severity::warning,  {model.deck_path, 0}, fmt::format("/{}/{}", keyword, id),
                    std::string(field), std::move(value),     std::move(rule),
                    std::move(remedy)};
    for (const Card& card : deck.starter) {
        if (card.words.empty() || card.words[0] != keyword.substr(0, keyword.find('/')) || !has_id(card, id)) continue;
        problem.place = deck.place(card);
        problem.card = card.keyword;
        break;
    }
    problems.add(std::move(problem));
}

void SurpriseCheck::at_interface(const Interface& interface, std::string_view field, std::string value,
                                 std::string rule, std::string remedy) const {
    problems.add({Severity::warning,
                  {interface.file, interface.line},
                  fmt::format("/INTER/TYPE21/{}", interface.id),
                  std::string(field),
                  std::move(value),
                  std::move(rule),
                  std::move(remedy)});
}

const Surface& SurpriseCheck::main_surface(const Interface& interface) const {
    return model.surfaces[static_cast<size_t>(interface.main_surface)];
}

const Surface& SurpriseCheck::secondary_surface(const Interface& interface) const {
    return model.surfaces[static_cast<size_t>(interface.secondary_surface)];
}

std::string SurpriseCheck::nodes_of(const Segment& segment) const {
    std::string text;
    for (int corner = 0; corner < segment.corners(); ++corner)
        text += fmt::format("{}{}", corner > 0 ? ", " : "",
                            model.nodes.id[static_cast<size_t>(segment.node[static_cast<size_t>(corner)])]);
    return text;
}

std::string SurpriseCheck::quantity(double value, Dimension dimension) const {
    const std::string unit = model.units.name(dimension);
    return fmt::format("{:.6g}{}{}", value, unit.empty() ? "" : " ", unit);
}

void warn_of_surprises(const Deck& deck, const Model& model, Problems& problems) {
    const SurpriseCheck check{deck, model, problems};
    warn_of_turned_segments(check);
    warn_of_open_seams(check);
    warn_of_thin_tools(check);
    warn_of_fine_tools(check);
    warn_of_void_blanks(check);
    warn_of_far_coordinates(check);
    warn_of_same_pairs(check);
    warn_of_implausible_values(check);
    warn_of_two_drives(check);
    warn_of_ending_functions(check);
    warn_of_long_steps(check);
}

}  // namespace type21
