#include <array>

#include <fmt/format.h>

#include "reference/model/numbers.h"
#include "reference/model/reading.h"
#include "reference/model/resolve_interfaces.h"

namespace type21 {

namespace {

/// Deck formats whose TYPE21 card is known: 120 to 140 and 2017 to 2026.
bool known_version(Id version) {
    return version == 120 || version == 130 || version == 140 || (version >= 2017 && version <= 2026);
}

std::string unit_name(const std::string& text, std::string_view si) {
    double factor = 0;
    return parse_real(text, factor) == NumberFault::none ? fmt::format("({} {})", text, si) : text;
}

/// One line of three unit words, 20 columns each.
UnitSystem unit_line(CardReader& reader, size_t line, std::string_view purpose) {
    UnitSystem units;
    struct Word {
        std::string_view name, si;
        double (*size)(const std::string&);
        double* value;
        std::string* text;
    };
    const std::array<Word, 3> words{{{"mass", "kg", mass_unit, &units.mass, &units.mass_name},
                                     {"length", "m", length_unit, &units.length, &units.length_name},
                                     {"time", "s", time_unit, &units.time, &units.time_name}}};
    int column = 1;
    for (const Word& word : words) {
        const std::string text = reader.text(line, column, column + 19);
        const double size = word.size(text);
        if (size > 0) {
            *word.value = size;
            *word.text = unit_name(text, word.si);
        } else {
            reader.error(
                static_cast<int>(line), fmt::format("{} unit{}", word.name, purpose), text,
                fmt::format("this is not a unit of {}", word.name),
                fmt::format("Write a word such as Mg, kg, g, m, mm, s, ms, or the factor to {}, in columns {} to {}",
                            word.si, column, column + 19));
        }
        column += 20;
    }
    return units;
}

void read_version(CardReader& reader, Model& model) {
    const Id version = reader.integer(1, 1, 10, "Invers");
    if (known_version(version)) {
        model.version = static_cast<int>(version);
        return;
    }
    reader.error(1, "Invers", fmt::format("{}", version),
                 version < 120 ? "decks older than version 120 have another TYPE21 card"
                               : "the deck version is one of 120, 130, 140, 2017 to 2026",
                 "Write the deck in the format of version 2017 or later");
}

}  // namespace

void read_begin(Reading& reading) {
    Model& model = reading.model;
    const Card* first = nullptr;
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword != Keyword::begin) continue;
        const UnitSystem si;
        CardReader reader(reading.deck, *entry.card, si, si, reading.problems);
        if (first != nullptr) {
            reader.error(-1, "", "", fmt::format("a deck has one /BEGIN; the first is in line {}", first->place.number),
                         "Remove one");
            continue;
        }
        first = entry.card;
        model.run_name = reader.text(0, 1, 100);
        read_version(reader, model);
        model.input_units = unit_line(reader, 2, " (input)");
        model.units = unit_line(reader, 3, " (work)");
        warn_of_excess(reader, 4);
    }
    if (first == nullptr) {
        Problem problem;
        problem.place.file = model.deck_path;
        problem.card = "/BEGIN";
        problem.rule = "a starter deck has a /BEGIN card with its version and units; there is none";
        problem.remedy = "Add it, or give the starter deck NAME_0000.rad instead of the engine deck";
        reading.problems.add(problem);
    }
    reading.each(
        Keyword::unit, reading.units, [] { return 0; },
        [&](CardReader& reader, Id id) {
            model.unit_ids[id] = unit_line(reader, 1, "");
            warn_of_excess(reader, 2);
        });
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword != Keyword::title || !model.title.empty()) continue;
        const UnitSystem si;
        const CardReader reader(reading.deck, *entry.card, si, si, reading.problems);
        model.title = reader.text(0, 1, 100);
    }
}

const UnitSystem& card_units(const Deck& deck, const Card& card, size_t position, const Model& model,
                             Problems& problems) {
    if (position >= card.words.size()) return model.input_units;
    const std::string& word = card.words[position];
    Id id = 0;
    if (parse_integer(word, id) == NumberFault::none) {
        if (id == 0) return model.input_units;
        if (const auto found = model.unit_ids.find(id); found != model.unit_ids.end()) return found->second;
    }
    CardReader reader(deck, card, model.input_units, model.units, problems);
    reader.error(-1, "unit_ID", word, "there is no /UNIT with this id", "Add the /UNIT card, or correct the id");
    return model.input_units;
}

}  // namespace type21
