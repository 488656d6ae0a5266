#include "reference/deck/submodels.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/id_columns.h"
#include "reference/deck/text_file.h"

namespace type21 {

namespace {

using Number = std::int64_t;

std::optional<Number> number(std::string_view word) {
    Number value = 0;
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

std::string_view columns(std::string_view line, int first, int last) {
    const auto begin = static_cast<std::size_t>(first - 1);
    return begin >= line.size() ? std::string_view{} : line.substr(begin, static_cast<std::size_t>(last) - begin);
}

/// Position of the id in the keyword: the first number behind the kind. "/ADMAS/0/5" has its type before it.
std::size_t id_word(const Card& card) {
    for (std::size_t i = card.words[0] == "ADMAS" ? 2 : 1; i < card.words.size(); ++i)
        if (number(card.words[i])) return i;
    return card.words.size();
}

struct Submodel {
    Card card;
    Number id = 0;
    std::string unit;                        ///< unit_ID in words, empty for that of the main deck
    std::array<Number, id_kinds> offsets{};  ///< by IdKind

    bool moves() const {
        return std::any_of(offsets.begin(), offsets.end(), [](Number offset) { return offset != 0; });
    }
};

class Expander {
  public:
    Expander(Deck& deck, Problems& problems) : deck_(deck), problems_(problems) {}

    void expand() {
        for (const Card& card : deck_.starter) {
            if (!card.words.empty() && card.words[0] == "UNIT")
                last_unit_ =
                    std::max(last_unit_, id_word(card) < card.words.size() ? *number(card.words[id_word(card)]) : 0);
        }
        std::optional<Submodel> open;
        for (Card& card : deck_.starter) {
            const std::string word = card.words.empty() ? "" : card.words[0];
            if (word == "SUBMODEL") {
                if (open)
                    complain(card, "a //SUBMODEL within another is not supported", "Close the first with //ENDSUB");
                open = begin(card);
            } else if (word == "ENDSUB") {
                if (!open) complain(card, "there is no //SUBMODEL that it ends", "Remove it, or add the //SUBMODEL");
                if (open) submodels_.insert(open->id);
                open.reset();
            } else if (open && word == "BEGIN") {
                take_units(card, *open);
            } else {
                if (open) move(card, *open);
                append(std::move(card), open ? open->id : 0);
            }
        }
        if (open) complain(open->card, "the submodel has no //ENDSUB", "Add it behind its last card");
        select_by_submodel();
        deck_.starter = std::move(cards_);
    }

  private:
    void complain(const Card& card, std::string rule, std::string remedy, std::string field = {},
                  std::string value = {}) {
        Problem problem;
        problem.place = deck_.place(card);
        problem.card = card.keyword;
        problem.field = std::move(field);
        problem.value = std::move(value);
        problem.rule = std::move(rule);
        problem.remedy = std::move(remedy);
        problems_.add(std::move(problem));
    }

    void append(Card card, Number owner) {
        cards_.push_back(std::move(card));
        owner_.push_back(owner);
    }

    Submodel begin(const Card& card) {
        Submodel submodel;
        submodel.card = card;
        const std::size_t word = id_word(card);
        submodel.id = word < card.words.size() ? *number(card.words[word]) : 0;
        if (submodel.id <= 0 || submodels_.count(submodel.id) > 0)
            complain(card, "a submodel has a positive id of its own", "Write //SUBMODEL/1");
        if (word + 1 < card.words.size() && card.words[word + 1] != "0") submodel.unit = card.words[word + 1];
        if (card.lines.size() < 2) return submodel;
        const std::string_view line = card.lines[1].text();
        constexpr std::array<IdKind, id_kinds> order{IdKind::other, IdKind::node,     IdKind::element,
                                                     IdKind::part,  IdKind::material, IdKind::property};
        for (std::size_t i = 0; i < order.size(); ++i) {
            const std::string_view text =
                trimmed(columns(line, 1 + 10 * static_cast<int>(i), 10 + 10 * static_cast<int>(i)));
            const std::optional<Number> offset = text.empty() ? 0 : number(text);
            if (!offset || *offset < 0)
                complain(card, "an offset is an integer that is not negative", "Give offsets of ten columns each",
                         "offset", std::string(text));
            submodel.offsets[static_cast<std::size_t>(order[i])] = offset.value_or(0);
        }
        for (Number& offset : submodel.offsets)
            if (offset == 0) offset = submodel.offsets[0];
        if (!trimmed(columns(line, 61, 1000)).empty())
            complain(card, "a //SUBMODEL has six offsets; more are not supported", "Leave columns 61 on blank",
                     "offset", std::string(trimmed(columns(line, 61, 1000))));
        return submodel;
    }

    /// The /BEGIN of a submodel: its input units become a /UNIT that its cards name.
    void take_units(const Card& card, Submodel& submodel) {
        if (card.lines.size() < 3 || trimmed(card.lines[2].text()).empty()) return;
        Card unit;
        submodel.unit = fmt::format("{}", ++last_unit_);
        unit.keyword = card.keyword;
        unit.words = {"UNIT", submodel.unit};
        unit.place = card.place;
        unit.lines = {card.lines[0], card.lines[2]};
        append(std::move(unit), 0);
    }

    void move(Card& card, const Submodel& submodel) {
        if (card.words.empty() || card.words[0] == "UNIT" || card.words[0] == "TITLE") return;
        const std::size_t id = id_word(card);
        if (!submodel.unit.empty() && (id + 1 == card.words.size() || !has_id(card)) && card.words.size() < id + 2)
            card.words.push_back(submodel.unit);
        if (!submodel.moves()) return;
        std::vector<IdField> fields;
        if (!id_fields(card, fields)) {
            complain(card, "this card is not supported in a //SUBMODEL with offsets: its ids would not be moved",
                     "Put the card outside the submodel and name the moved ids");
            return;
        }
        const auto offset = [&](IdKind kind) { return submodel.offsets[static_cast<std::size_t>(kind)]; };
        if (has_id(card) && id < card.words.size()) {
            const Number own = *number(card.words[id]);
            if (own > 0) card.words[id] = fmt::format("{}", own + offset(kind_of_keyword(card)));
        }
        move_fields(card, fields, offset);
    }

    template <class Offset>
    void move_fields(Card& card, const std::vector<IdField>& fields, const Offset& offset) {
        std::map<std::size_t, std::string> lines;
        for (const IdField& field : fields) {
            if (field.line >= card.lines.size()) continue;
            const std::string_view text = card.lines[field.line].text();
            const std::optional<Number> value = number(trimmed(columns(text, field.first, field.first + 9)));
            if (!value || *value == 0) continue;
            const Number moved = *value < 0 ? *value - offset(field.kind) : *value + offset(field.kind);
            const std::string written = fmt::format("{:>10}", moved);
            if (written.size() > 10)
                complain(card, "a moved id does not fit into ten columns", "Give the submodel smaller offsets", "id",
                         written);
            const auto at = static_cast<std::size_t>(field.first - 1);
            std::string& line = lines.try_emplace(field.line, text).first->second;
            if (line.size() < at + 10) line.resize(at + 10, ' ');
            line.replace(at, 10, written.substr(0, 10));
        }
        rewrite(card, lines);
    }

    /// /GRNOD/SUBMODEL and its like, and the sub_ID of a /TRANSFORM, become lists of ids.
    void select_by_submodel() {
        static const std::map<std::string, std::pair<std::string, std::string>, std::less<>> kinds{
            {"GRNOD", {"NODE", "NODE"}},
            {"GRSHEL", {"SHELL", "SHEL"}},
            {"GRSH3N", {"SH3N", "SH3N"}},
            {"GRPART", {"PART", "PART"}},
            {"SURF", {"PART", "PART"}}};
        for (const Card& card : cards_) {
            const bool group = !card.words.empty() && (card.words[0] == "GRNOD" || card.words[0] == "SET");
            if (group && id_word(card) < card.words.size())
                last_group_ = std::max(last_group_, *number(card.words[id_word(card)]));
        }
        const std::size_t count = cards_.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (cards_[i].words.size() < 2) continue;
            const auto kind = kinds.find(cards_[i].words[0]);
            if (cards_[i].words[1] == "SUBMODEL" && kind != kinds.end()) {
                std::string text;
                int column = 0;
                bool known = true;
                for (std::size_t line = 1; line < cards_[i].lines.size(); ++line) {
                    for (int first = 1; first <= 91; first += 10)
                        known = list(cards_[i], line, first, kind->second.first, text, column) && known;
                }
                if (!known) continue;  // an error as soon as a card uses it
                set_list(cards_[i], text);
                cards_[i].words[1] = kind->second.second;
            } else if (cards_[i].words[0] == "TRANSFORM" && cards_[i].lines.size() > 1) {
                name_group(i);
            }
        }
    }

    /// The submodel of a /TRANSFORM as a group of nodes.
    void name_group(std::size_t i) {
        const int first = cards_[i].words[1] == "MATRIX" ? 11 : 91;
        const std::string_view line = cards_[i].lines[1].text();
        const std::optional<Number> submodel = number(trimmed(columns(line, first, first + 9)));
        if (!submodel || *submodel == 0) return;
        const std::string_view group = trimmed(columns(line, 1, 10));
        if (!group.empty() && group != "0") {
            complain(cards_[i], "a /TRANSFORM moves a group of nodes or a submodel; grnod_ID is given, too",
                     "Give one of them", "sub_ID", fmt::format("{}", *submodel));
            return;
        }
        std::string text;
        int column = 0;
        if (!list(cards_[i], 1, first, "NODE", text, column)) {
            complain(cards_[i], "there is no //SUBMODEL with this id", "Add it, or correct the id", "sub_ID",
                     fmt::format("{}", *submodel));
            return;
        }
        Card nodes;
        nodes.keyword = cards_[i].keyword;
        nodes.words = {"GRNOD", "NODE", fmt::format("{}", ++last_group_)};
        nodes.place = cards_[i].place;
        nodes.lines = {cards_[i].lines[0]};
        set_list(nodes, text);
        std::string written(line);
        written.resize(std::max<std::size_t>(written.size(), 100), ' ');
        written.replace(0, 10, fmt::format("{:>10}", last_group_));
        written.replace(static_cast<std::size_t>(first - 1), 10, std::string(10, ' '));
        rewrite(cards_[i], {{1, written}});
        append(std::move(nodes), 0);
    }

    /// Appends the ids that the submodel in this field has of one kind of card, with the sign of the field. False when
    /// there is no such submodel.
    bool list(const Card& card, std::size_t line, int first, const std::string& keyword, std::string& text,
              int& column) {
        const std::string_view word = trimmed(columns(card.lines[line].text(), first, first + 9));
        const std::optional<Number> submodel = word.empty() ? Number{0} : number(word);
        if (submodel && *submodel == 0) return true;
        if (!submodel || submodels_.count(std::abs(*submodel)) == 0) return false;
        const auto add = [&](std::string_view id) {
            const std::string written = (*submodel < 0 ? "-" : "") + std::string(id);
            text += fmt::format("{:>10}", written);
            if (++column % 10 == 0) text += '\n';
        };
        for (std::size_t i = 0; i < cards_.size(); ++i) {
            const Card& member = cards_[i];
            if (owner_[i] != std::abs(*submodel) || member.words.empty() || member.words[0] != keyword) continue;
            if (keyword == "PART") {
                if (id_word(member) < member.words.size()) add(member.words[id_word(member)]);
                continue;
            }
            for (const DataLine& data : member.lines) {
                const std::string_view id = trimmed(columns(data.text(), 1, 10));
                if (number(id)) add(id);
            }
        }
        return true;
    }

    /// Puts lines of ids behind the title of a list card.
    void set_list(Card& card, const std::string& text) {
        auto all = std::make_shared<const std::string>(text);
        const DataLine title = card.lines.empty() ? DataLine("", card.place.file, card.place.number) : card.lines[0];
        card.lines = {title};
        for (std::size_t at = 0; at < all->size();) {
            const std::size_t end = std::min(all->find('\n', at), all->size());
            card.lines.emplace_back(std::string_view(*all).substr(at, end - at), card.place.file, card.place.number);
            at = end + 1;
        }
        deck_.texts.push_back(std::move(all));
    }

    void rewrite(Card& card, const std::map<std::size_t, std::string>& lines) {
        std::size_t size = 0;
        for (const auto& [line, text] : lines)
            size += text.size();
        auto all = std::make_shared<std::string>();
        all->reserve(size);
        for (const auto& [line, text] : lines)
            *all += text;
        std::size_t at = 0;
        for (const auto& [line, text] : lines) {
            DataLine& data = card.lines[line];
            data = DataLine(std::string_view(*all).substr(at, text.size()), data.file, data.number);
            at += text.size();
        }
        deck_.texts.push_back(std::move(all));
    }

    Deck& deck_;
    Problems& problems_;
    std::vector<Card> cards_;
    std::vector<Number> owner_;  ///< submodel of each card, 0: none
    std::set<Number> submodels_;
    Number last_unit_ = 0;
    Number last_group_ = 0;
};

}  // namespace

void expand_submodels(Deck& deck, Problems& problems) {
    const bool any = std::any_of(deck.starter.begin(), deck.starter.end(), [](const Card& card) {
        if (card.words.empty()) return false;
        const std::string& word = card.words[0];
        return word == "SUBMODEL" || word == "ENDSUB" || word == "TRANSFORM";
    });
    if (any) Expander(deck, problems).expand();
}

}  // namespace type21
