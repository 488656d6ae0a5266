#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "reference/deck/text_file.h"
#include "reference/model/card_lines.h"
#include "reference/model/numbers.h"
#include "reference/model/reading.h"
#include "reference/model/resolve_interfaces.h"

namespace type21 {

namespace {

/// Deck formats whose TYPE21 card is known: 120 to 140 and 2017 to 2026.
bool known_version(Id version) {
    return version == 120 || version == 130 || version == 140 || (version >= 2017 && version <= 2026);
}

/// What stands for a unit in a deck that names none: the letter of its dimension.
UnitSystem nameless_units() {
    UnitSystem units;
    units.mass_name = "M";
    units.length_name = "L";
    units.time_name = "T";
    units.named = false;
    return units;
}

std::string unit_name(const std::string& text, std::string_view si) {
    double factor = 0;
    return parse_real(text, factor) == NumberFault::none ? fmt::format("({} {})", text, si) : text;
}

/// The three words of a line, 20 columns each; printable, as they are shown in messages.
using UnitWords = std::array<std::string, 3>;

UnitWords unit_words(const CardReader& reader, size_t line) {
    return {reader.text(line, 1, 20), reader.text(line, 21, 40), reader.text(line, 41, 60)};
}

bool all_blank(const UnitWords& words) {
    return std::all_of(words.begin(), words.end(), [](const std::string& word) { return word.empty(); });
}

UnitSystem unit_line(CardReader& reader, size_t line, const UnitWords& texts, std::string_view purpose) {
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
    for (size_t i = 0; i < words.size(); ++i) {
        const Word& word = words[i];
        const double size = word.size(texts[i]);
        if (size > 0) {
            *word.value = size;
            *word.text = unit_name(texts[i], word.si);
            continue;
        }
        reader.error(
            static_cast<int>(line), fmt::format("{} unit{}", word.name, purpose), texts[i],
            fmt::format("this is not a unit of {}", word.name),
            fmt::format("Write a word such as Mg, kg, g, m, mm, s, ms, or the factor to {}, in columns {} to {}",
                        word.si, 20 * i + 1, 20 * i + 20));
    }
    return units;
}

/// Input and work units. Where neither line names a unit, the numbers are taken as they are: a deck is consistent in
/// itself. A blank word in one line means the word of the other, so that nothing is converted.
void read_units(CardReader& reader, Model& model) {
    UnitWords input = unit_words(reader, 2);
    UnitWords work = unit_words(reader, 3);
    if (all_blank(input) && all_blank(work)) {
        model.input_units = model.units = nameless_units();
        return;
    }
    constexpr std::array<std::string_view, 3> names{"mass", "length", "time"};
    for (size_t i = 0; i < names.size(); ++i) {
        if (input[i].empty() == work[i].empty()) continue;
        const bool input_is_blank = input[i].empty();
        std::string& blank = input_is_blank ? input[i] : work[i];
        blank = input_is_blank ? work[i] : input[i];
        reader.warning(input_is_blank ? 2 : 3, fmt::format("{} unit", names[i]), blank,
                       fmt::format("the {} unit is blank, that of the {} line is taken: nothing is converted",
                                   input_is_blank ? "input" : "work", input_is_blank ? "work" : "input"),
                       "Write the unit in both lines");
    }
    model.input_units = unit_line(reader, 2, input, " (input)");
    model.units = unit_line(reader, 3, work, " (work)");
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

/// Version and units of a /BEGIN card, blanks and case aside.
std::string begin_text(const Card& card) {
    std::string text;
    for (size_t line = 1; line < std::min<size_t>(4, card.lines.size()); ++line) {
        for (const char c : upper(card.lines[line].text()))
            if (c != ' ' || !text.ends_with(' ')) text += c;
        text += ' ';
    }
    return text;
}

/// The /BEGIN of an included file is not read, so its units count for nothing.
void compare_with_includes(Reading& reading, const Card& main) {
    for (const Card& other : reading.deck.unread) {
        if (begin_text(other) == begin_text(main)) continue;
        Problem problem;
        problem.severity = Severity::warning;
        problem.place = reading.deck.place(other);
        problem.card = "/BEGIN";
        problem.rule = "that of an included file is not read, and its version or units differ from the main deck's";
        problem.remedy = "Convert the numbers of the file where its units are others";
        reading.problems.add(problem);
    }
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
        reader.need(needed_lines(Keyword::begin));
        reader.unused(1, 11, 20, 10);
        read_units(reader, model);
        warn_of_excess(reader, 4);
        reader.finish();
    }
    if (first == nullptr) {
        Problem problem;
        problem.place.file = model.deck_path;
        problem.card = "/BEGIN";
        problem.rule = "a starter deck has a /BEGIN card with its version and units; there is none";
        problem.remedy = reading.deck.unread.empty()
                             ? "Add it as the first card of the starter deck NAME_0000.rad"
                             : "Add it as the first card; that of an included file does not count";
        reading.problems.add(problem);
    } else {
        compare_with_includes(reading, *first);
    }
    reading.each(
        Keyword::unit, reading.units, [] { return 0; },
        [&](CardReader& reader, Id id) {
            model.unit_ids[id] = unit_line(reader, 1, unit_words(reader, 1), "");
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
        if (const auto found = model.unit_ids.find(id); found != model.unit_ids.end()) {
            if (model.units.named) return found->second;
            CardReader reader(deck, card, model.input_units, model.units, problems);
            reader.error(-1, "unit_ID", word, "/BEGIN names no units, so there is nothing to convert to",
                         "Name the units in /BEGIN, or leave unit_ID out");
            return model.input_units;
        }
    }
    CardReader reader(deck, card, model.input_units, model.units, problems);
    reader.error(-1, "unit_ID", word, "there is no /UNIT with this id", "Add the /UNIT card, or correct the id");
    return model.input_units;
}

}  // namespace type21
