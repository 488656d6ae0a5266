#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

#include <fmt/format.h>

#include "reference/deck/text_file.h"
#include "reference/model/selector.h"

namespace type21 {

/// One clause of a /SET: a word in columns 1 to 10, ids in fields of ten columns behind it and on the lines below.
struct Selector::Clause {
    enum class Effect { add, take_away, keep_common };
    Effect effect = Effect::add;
    bool range = false;  ///< the ids are first, last, step
    std::string type;    ///< "PART"
    std::vector<ListedId> ids;
};

namespace {

constexpr std::array<std::string_view, 12> clause_types{"ALL",    "NODE", "PART", "SHELL", "SH3N", "ELEM",
                                                        "SUBSET", "MAT",  "PROP", "BOX",   "SEG",  "SET"};

bool known(std::string_view type) {
    return std::find(clause_types.begin(), clause_types.end(), type) != clause_types.end();
}

bool has_letter(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
}

/// The same for a segment and its like with another first node or the other sense.
std::array<int, 4> corners(const Segment& segment) {
    std::array<int, 4> nodes = segment.node;
    if (segment.is_triangle()) nodes[3] = -1;
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

}  // namespace

/// A letter behind the word or in columns 11 to 20 says how it acts: D takes away, I keeps what is common, G gives
/// ranges, A and E (all faces, outer faces) mean nothing for shells. "DPART" and "-PART" are "PART_D".
std::vector<Selector::Clause> Selector::clauses(CardReader& reader) {
    std::vector<Clause> all;
    for (size_t line = 1; line < reader.line_count(); ++line) {
        if (reader.blank(line, 1, 100)) continue;
        std::string word = upper(reader.text(line, 1, 10));
        int column = word.empty() || has_letter(word) ? 11 : 1;
        if (column == 11 && !word.empty()) {
            Clause clause;
            std::string letters;
            const std::string written = word;
            if (word.starts_with('-')) {
                letters += 'D';
                word.erase(0, 1);
            }
            const std::string options = upper(reader.text(line, 11, 20));
            if (has_letter(options)) {
                letters += options;
                column = 21;
            }
            while (word.size() > 2 && word[word.size() - 2] == '_' && !known(word)) {
                letters += word.back();
                word.resize(word.size() - 2);
            }
            if (!known(word) && (word[0] == 'D' || word[0] == 'I') && known(word.substr(1))) {
                letters += word[0];
                word.erase(0, 1);
            }
            clause.type = word;
            for (const char letter : letters) {
                if (letter == 'D') clause.effect = Clause::Effect::take_away;
                if (letter == 'I') clause.effect = Clause::Effect::keep_common;
                if (letter == 'G') clause.range = true;
            }
            const bool odd = letters.find_first_not_of("DIGAE_ ") != std::string::npos;
            if (!known(word) || odd || (clause.range && (word == "SEG" || word == "ALL"))) {
                reader.error(static_cast<int>(line), "KEY_type", odd ? fmt::format("{} {}", written, options) : written,
                             "this clause of a /SET is not supported",
                             fmt::format("Use one of {}, with _G for ranges and _D to take away",
                                         fmt::join(clause_types, ", ")));
            }
            all.push_back(std::move(clause));
        } else if (all.empty()) {
            reader.error(static_cast<int>(line), "KEY_type", word, "a clause of a /SET begins with a word",
                         "Write NODE, PART, SHELL or another in columns 1 to 10, the ids behind it");
            for (size_t rest = line; rest < reader.line_count(); ++rest)
                reader.skip(rest, 1, 101);  // what they hold has no meaning any more
            return {};
        }
        for (; column <= 91; column += 10) {
            const Id id = reader.integer(line, column, column + 9, "ids");
            if (id != 0) all.back().ids.push_back({id, line});
        }
    }
    return all;
}

std::vector<Link> Selector::open_set(const SelectionCard& card, CardReader& reader, Content& content) {
    if (card.type != "GENERAL") {
        complain_of_type(card, reader);
        return {};
    }
    const std::vector<Clause> list = clauses(reader);
    std::vector<Link> links;
    if (std::all_of(list.begin(), list.end(), [](const Clause& c) { return c.effect == Clause::Effect::add; })) {
        for (const Clause& clause : list) {
            const std::vector<Link> more = open_clause(clause, reader, content);
            links.insert(links.end(), more.begin(), more.end());
        }
        return links;
    }
    Content so_far;
    for (const Clause& clause : list) {
        Content own;
        for (const Link& link : open_clause(clause, reader, own)) {
            if (open_.count(link.card) > 0) {
                complain_of_circle(*link.card);
                continue;
            }
            Content other = gather(*link.card);
            const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
            append(own.nodes, nodes_of(other));
            append(own.bare_shells, shells_of(other, ShellKind::any));
            append(own.bare_parts, parts_of(other));
            append(own.segments, other.segments);
        }
        const auto change = [&](std::vector<int>& to, const std::vector<int>& by) {
            std::vector<int> result;
            if (clause.effect == Clause::Effect::add) {
                std::set_union(to.begin(), to.end(), by.begin(), by.end(), std::back_inserter(result));
            } else if (clause.effect == Clause::Effect::take_away) {
                std::set_difference(to.begin(), to.end(), by.begin(), by.end(), std::back_inserter(result));
            } else {
                std::set_intersection(to.begin(), to.end(), by.begin(), by.end(), std::back_inserter(result));
            }
            to = std::move(result);
        };
        change(so_far.nodes, nodes_of(own));
        change(so_far.bare_shells, shells_of(own, ShellKind::any));
        change(so_far.bare_parts, parts_of(own));
        if (clause.effect == Clause::Effect::add) {
            so_far.segments.insert(so_far.segments.end(), own.segments.begin(), own.segments.end());
        } else {
            const bool take_away = clause.effect == Clause::Effect::take_away;
            std::vector<std::array<int, 4>> named;
            for (const Segment& segment : own.segments)
                named.push_back(corners(segment));
            std::sort(named.begin(), named.end());
            std::erase_if(so_far.segments, [&](const Segment& segment) {
                return std::binary_search(named.begin(), named.end(), corners(segment)) == take_away;
            });
        }
    }
    content.nodes.insert(content.nodes.end(), so_far.nodes.begin(), so_far.nodes.end());
    content.bare_shells.insert(content.bare_shells.end(), so_far.bare_shells.begin(), so_far.bare_shells.end());
    content.bare_parts.insert(content.bare_parts.end(), so_far.bare_parts.begin(), so_far.bare_parts.end());
    content.segments.insert(content.segments.end(), so_far.segments.begin(), so_far.segments.end());
    return {};
}

std::vector<Link> Selector::open_clause(const Clause& clause, CardReader& reader, Content& content) {
    if (clause.type == "ALL") {
        const auto all = [](std::vector<int>& numbers, size_t count) {
            for (size_t i = 0; i < count; ++i)
                numbers.push_back(static_cast<int>(i));
        };
        all(content.nodes, reading_.model.nodes.id.size());
        all(content.parts, reading_.model.parts.size());
        return {};
    }
    if (clause.range) {
        append_ranges(clause, reader, content);
        return {};
    }
    if (clause.type == "SEG") {
        append_segments(clause, reader, content);
        return {};
    }
    std::vector<Link> links;
    for (const ListedId& listed : clause.ids) {
        if (listed.id < 0) {
            reader.error(static_cast<int>(listed.line), "ids", fmt::format("{}", listed.id),
                         "negative ids are not supported in a /SET", "Take members away with _D behind the word");
        } else if (clause.type == "NODE") {
            append_node(reader, listed.line, listed.id, content.nodes);
        } else if (clause.type == "SHELL" || clause.type == "SH3N") {
            append_shell(reader, listed.line, clause.type == "SHELL" ? ShellKind::shell : ShellKind::sh3n, listed.id,
                         content.shells);
        } else if (clause.type == "ELEM") {
            const int sh3n = mesh_.shell(ShellKind::sh3n, listed.id);
            if (sh3n >= 0) content.shells.push_back(sh3n);
            if (sh3n < 0 || mesh_.shell(ShellKind::shell, listed.id) >= 0)
                append_shell(reader, listed.line, ShellKind::shell, listed.id, content.shells);
        } else if (clause.type == "BOX") {
            const SelectionCard* box = find(reader, listed.line, Family::box, listed.id);
            if (box == nullptr) continue;
            const std::vector<int> inside = nodes(*box);
            content.nodes.insert(content.nodes.end(), inside.begin(), inside.end());
            append_boxed(*box, ShellKind::any, true, content.shells);
        } else if (clause.type == "SET") {
            const SelectionCard* other = find(reader, listed.line, Family::set, listed.id);
            if (other != nullptr) links.push_back({other, Family::set});
        } else if (PartChoice::knows(clause.type)) {
            part_choice_.append(reader, listed.line, clause.type, listed.id, content.parts);
        }
    }
    return links;
}

/// A line holds one segment: its number and its nodes, as in /SURF/SEG, or the nodes alone. With four numbers these are
/// the nodes, unless a 0 follows them.
void Selector::append_segments(const Clause& clause, CardReader& reader, Content& content) {
    for (size_t i = 0; i < clause.ids.size();) {
        const size_t line = clause.ids[i].line;
        std::vector<Id> numbers;
        for (; i < clause.ids.size() && clause.ids[i].line == line; ++i)
            numbers.push_back(clause.ids[i].id);
        const bool numbered = numbers.size() == 5 || (numbers.size() == 4 && !reader.blank(line, 51, 60));
        if (numbered) numbers.erase(numbers.begin());
        if (numbers.size() < 3 || numbers.size() > 4) {
            reader.error(static_cast<int>(line), "SEG", fmt::format("{}", fmt::join(numbers, " ")),
                         "a segment has its number and four nodes, the last one 0 for a triangle",
                         "Give five fields of ten columns");
            continue;
        }
        numbers.resize(4, 0);
        std::vector<Segment> own;
        append_segment(reader, line, {numbers[0], numbers[1], numbers[2], numbers[3]}, own);
        for (const Segment& segment : own) {
            content.segments.push_back(segment);
            content.nodes.insert(content.nodes.end(), segment.node.begin(), segment.node.end());
        }
    }
}

/// Ids from the first to the last of those that the deck has; ids between them that it does not have are no error.
void Selector::append_ranges(const Clause& clause, CardReader& reader, Content& content) {
    const std::vector<ListedId>& ids = clause.ids;
    const size_t line = ids.empty() ? 0 : ids.front().line;
    const IdRange range{ids.empty() ? 0 : ids[0].id, ids.size() < 2 ? 0 : ids[1].id, ids.size() < 3 ? 1 : ids[2].id};
    if (ids.size() > 3 || range.first <= 0 || range.last < range.first || range.step <= 0) {
        reader.error(static_cast<int>(line), "ids", fmt::format("{} {} {}", range.first, range.last, range.step),
                     "a range is a first id above 0, a last one that is not below it, and a step above 0",
                     "Give one range in a clause");
        return;
    }
    if (clause.type == "NODE") {
        append_node_range(range.first, range.last, range.step, content.nodes);
    } else if (clause.type == "SHELL" || clause.type == "SH3N" || clause.type == "ELEM") {
        if (clause.type != "SH3N")
            mesh_.append_range(ShellKind::shell, range.first, range.last, range.step, content.shells);
        if (clause.type != "SHELL")
            mesh_.append_range(ShellKind::sh3n, range.first, range.last, range.step, content.shells);
    } else if (clause.type == "PART") {
        append_part_range(range.first, range.last, range.step, content.parts);
    } else {
        reader.error(static_cast<int>(line), "KEY_type", clause.type + "_G",
                     "ranges are supported of NODE, SHELL, SH3N, ELEM and PART", "List the ids");
    }
}

}  // namespace type21
