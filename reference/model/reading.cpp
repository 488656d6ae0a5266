#include "reference/model/reading.h"

#include <array>

#include <fmt/format.h>

#include "reference/deck/text_file.h"
#include "reference/model/card_lines.h"
#include "reference/model/numbers.h"
#include "reference/model/resolve_interfaces.h"
#include "reference/model/selector.h"

namespace type21 {

Reading::Reading(const Deck& deck_, Model& model_, Problems& problems_)
    : deck(deck_), model(model_), problems(problems_) {
    cards.reserve(deck.starter.size());
    for (const Card& card : deck.starter)
        cards.push_back({&card, match(card)});
}

Reading::~Reading() = default;

CardReader Reading::reader(const Card& card, size_t unit_position) {
    return {deck, card, card_units(deck, card, unit_position, model, problems), model.units, problems};
}

void Reading::each(Keyword keyword, Registry& registry, const std::function<int()>& index,
                   const std::function<void(CardReader&, Id)>& read) {
    for (const ReadCard& entry : cards) {
        if (entry.match.keyword != keyword) continue;
        const Card& card = *entry.card;
        CardReader card_reader = reader(card, entry.match.words + 1);
        const std::optional<Id> id = id_of(card, entry.match.words, card_reader);
        if (!id) continue;
        const auto [known, is_new] = registry.entries.emplace(*id, Registry::Entry{index(), deck.place(card)});
        if (!is_new) {
            const Place& first = known->second.place;
            card_reader.error(-1, "id", fmt::format("{}", *id),
                              fmt::format("the id is taken by the card at {}:{}", first.file, first.line),
                              "Give each its own id, or remove one");
            continue;
        }
        card_reader.need(needed_lines(keyword));
        read(card_reader, *id);
        card_reader.finish();
    }
}

int Reading::member(CardReader& reader, size_t line, std::string_view field, Id id, const Registry& registry,
                    bool required) {
    const auto where = static_cast<int>(line);
    if (id == 0) {
        if (required) {
            reader.error(where, field, "0", fmt::format("the id of a {} is asked for", registry.keyword),
                         fmt::format("Fill in {}", field));
        }
        return -1;
    }
    const int index = registry.find(id);
    if (index >= 0 || registry.entries.count(id) != 0 || registry.unsupported.count(id) != 0) return index;
    if (const auto unread = registry.unread.find(id); unread != registry.unread.end()) {
        reader.error(where, field, fmt::format("{}", id),
                     fmt::format("names {}, a card that is not supported", unread->second),
                     fmt::format("Use another kind of {}", registry.keyword));
    } else {
        reader.error(where, field, fmt::format("{}", id), fmt::format("there is no {} with this id", registry.keyword),
                     fmt::format("Add the {} card, or correct the id", registry.keyword));
    }
    return index;
}

int Reading::reference(CardReader& reader, size_t line, std::string_view field, Id id, const Registry& registry,
                       bool required) {
    const int index = member(reader, line, field, id, registry, required);
    if (index < 0 || !is_empty(registry, index)) return index;
    reader.error(static_cast<int>(line), field, fmt::format("{}", id),
                 fmt::format("this {} is empty, so the card would act on nothing", registry.keyword),
                 "Add its members, or remove the card");
    return -1;
}

bool Reading::is_empty(const Registry& registry, int index) const {
    const auto i = static_cast<size_t>(index);
    if (&registry == &groups) return i < model.groups.size() && model.groups[i].nodes.empty();
    if (&registry == &surfaces) return i < model.surfaces.size() && model.surfaces[i].segments.empty();
    return false;
}

int Reading::reference(CardReader& reader, size_t line, int first, int last, std::string_view field,
                       const Registry& registry, bool required) {
    return reference(reader, line, field, reader.integer(line, first, last, field), registry, required);
}

void Reading::ignore(const Card& card) {
    if (!first_ignored_) first_ignored_ = deck.place(card);
    const std::string second = card.words.size() > 1 ? card.words[1] : "";
    const bool with_kind = card.words[0] == "TH" || card.words[0] == "DEFAULT";
    ++ignored_["/" + card.words[0] + (with_kind && !second.empty() ? "/" + second : "")];
}

void Reading::say_ignored() {
    if (!first_ignored_) return;
    std::string list;
    for (const auto& [keyword, count] : ignored_) {
        list += fmt::format("{}{}{}", list.empty() ? "" : ", ", keyword, count > 1 ? fmt::format(" ({})", count) : "");
    }
    Problem problem;
    problem.severity = Severity::warning;
    problem.place = *first_ignored_;
    problem.value = list;
    problem.rule =
        "these cards are ignored: they steer output that is not written here or elements whose forces are "
        "not computed";
    problem.remedy = "Nothing needs to be done";
    problems.add(problem);
}

std::optional<Id> id_of(const Card& card, size_t position, CardReader& reader) {
    Id id = 0;
    const std::string word = position < card.words.size() ? card.words[position] : "";
    if (parse_integer(word, id) == NumberFault::none && id > 0) return id;
    reader.error(-1, "id", word, "a positive integer is asked for as the id",
                 "Write it behind the keyword, as in /PART/1");
    return std::nullopt;
}

void refuse_unless_zero(CardReader& reader, size_t line, int first, int last, std::string_view field,
                        std::string_view feature) {
    const Id value = reader.integer(line, first, last, field);
    if (value == 0) return;
    reader.error(static_cast<int>(line), field, fmt::format("{}", value), fmt::format("{} not supported", feature),
                 "Set it to 0, or model the effect otherwise");
}

void warn_of_excess(CardReader& reader, size_t lines) {
    for (size_t line = lines; line < reader.line_count(); ++line) {
        if (reader.blank(line, 1, 1000)) continue;
        reader.warning(static_cast<int>(line), "", "",
                       fmt::format("the card has {} data lines; what follows is not read", lines),
                       "Remove the lines, or add the keyword that they belong to");
        return;
    }
}

std::vector<ListedId> listed_ids(CardReader& reader, size_t first_line, std::string_view field) {
    std::vector<ListedId> ids;
    for (size_t line = first_line; line < reader.line_count(); ++line) {
        for (int column = 1; column <= 91; column += 10) {
            const Id id = reader.integer(line, column, column + 9, field);
            if (id != 0) ids.push_back({id, line});
        }
        if (!reader.blank(line, 101, 10000))
            reader.warning(static_cast<int>(line), field, reader.text(line, 101, 10000),
                           "a line of ids has ten fields of ten columns; what stands beyond column 100 is not read",
                           "Continue on the next line");
        reader.skip(line, 101, 101);
    }
    return ids;
}

int direction(CardReader& reader, size_t line, int first, int last) {
    const std::string word = upper(reader.text(line, first, last));
    for (size_t i = 0; i < direction_names.size(); ++i) {
        if (word == direction_names[i]) return static_cast<int>(i);
    }
    reader.error(static_cast<int>(line), "Dir", word, "the direction is one of X, Y, Z, XX, YY, ZZ",
                 fmt::format("Write it in columns {} to {}", first, last));
    return -1;
}

std::string quantity(const CardReader& reader, double value, Dimension dimension) {
    const std::string unit = reader.to().name(dimension);
    return unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
}

}  // namespace type21
