#include "reference/model/selector.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "reference/model/resolve_interfaces.h"

namespace type21 {

namespace {

constexpr int max_depth = 100;  ///< of differences within differences; unions may be nested as deep as one likes

bool has_box(const SelectionCards& cards) {
    return std::any_of(cards.all().begin(), cards.all().end(),
                       [](const SelectionCard& card) { return card.family == Family::box; });
}

void append(std::vector<int>& to, const std::vector<int>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Selector::Selector(Reading& reading)
    : reading_(reading), cards_(reading), part_choice_(reading, cards_), mesh_(reading.model, reading.first_sh3n) {}

void Selector::place_nodes() {
    placed_ = true;
    if (has_box(cards_)) positions_ = reading_.model.nodes.position;
}

std::vector<int> Selector::nodes(const SelectionCard& card) {
    if (card.family == Family::surface) {
        std::vector<int> all;
        for (const Segment& segment : segments(card))
            all.insert(all.end(), segment.node.begin(), segment.node.end());
        sort_once(all, reading_.model.nodes.id.size());
        return all;
    }
    return nodes_of(gather(card));
}

std::vector<int> Selector::shells(const SelectionCard& card, ShellKind kind) {
    return shells_of(gather(card), kind);
}

std::vector<int> Selector::parts(const SelectionCard& card) {
    return parts_of(gather(card));
}

const SelectionCard* Selector::find(CardReader& reader, size_t line, Family family, Id id, std::string_view field) {
    const auto where = static_cast<int>(line);
    const std::string_view name = field.empty() ? field_of(family) : field;
    const SelectionCard* card = cards_.find(family, id);
    if (card == nullptr) {
        reader.error(where, name, fmt::format("{}", id), fmt::format("there is no {} with this id", keyword_of(family)),
                     fmt::format("Add the {} card, or correct the id", keyword_of(family)));
    } else if (cards_.ambiguous(family, id)) {
        reader.error(where, name, fmt::format("{}", id),
                     fmt::format("a {} and a /SET have this id", keyword_of(family)), "Give one of them another id");
        return nullptr;
    }
    return card;
}

CardReader Selector::reader(const SelectionCard& card) {
    const bool first = read_.insert(&card).second;
    Problems& problems = first ? reading_.problems : told_before_;
    return {reading_.deck, *card.card, card_units(reading_.deck, *card.card, card.unit_word, reading_.model, problems),
            reading_.model.units, problems};
}

Content Selector::gather(const SelectionCard& card) {
    struct Frame {
        const SelectionCard* card;
        std::vector<Link> links;
        size_t next = 0;
    };
    Content content;
    if (depth_ >= max_depth) {
        reader(card).error(-1, field_of(card.family), fmt::format("{}", card.id),
                           fmt::format("groups that take others away are nested at most {} deep", max_depth),
                           "List the members themselves");
        return content;
    }
    ++depth_;
    std::unordered_set<const SelectionCard*> reached;
    std::vector<Frame> stack;
    const auto enter = [&](const SelectionCard& next) {
        if (open_.count(&next) > 0) {
            complain_of_circle(next);
            return;
        }
        if (!reached.insert(&next).second) return;
        open_.insert(&next);
        stack.push_back({&next, open(next, content)});
    };
    enter(card);
    while (!stack.empty()) {
        Frame& frame = stack.back();
        if (frame.next == frame.links.size()) {
            open_.erase(frame.card);
            stack.pop_back();
            continue;
        }
        const Link link = frame.links[frame.next++];
        if (link.card->family == Family::set && link.as != Family::set) {
            take(link, content);
        } else {
            enter(*link.card);
        }
    }
    --depth_;
    return content;
}

void Selector::take(const Link& link, Content& content) {
    std::vector<int>& to = link.as == Family::node_group   ? content.nodes
                           : link.as == Family::part_group ? content.parts
                                                           : content.shells;
    append(to, items(*link.card, link.as));
}

std::vector<int> Selector::items(const SelectionCard& card, Family family) {
    switch (family) {
        case Family::part_group:
            return parts(card);
        case Family::shell_group:
            return shells(card, ShellKind::shell);
        case Family::sh3n_group:
            return shells(card, ShellKind::sh3n);
        default:
            return nodes(card);
    }
}

std::vector<Link> Selector::open(const SelectionCard& card, Content& content) {
    CardReader card_reader = reader(card);
    card_reader.need({"title"});
    std::vector<Link> links;
    if (card.family == Family::node_group) {
        links = open_node_group(card, card_reader, content);
    } else if (card.family == Family::shell_group || card.family == Family::sh3n_group) {
        links = open_shell_group(card, card_reader, content);
    } else if (card.family == Family::part_group) {
        links = open_part_group(card, card_reader, content);
    } else if (card.family == Family::box) {
        links = open_box(card, card_reader, content);
    } else {
        links = open_set(card, card_reader, content);
    }
    card_reader.finish();
    return links;
}

std::vector<Link> Selector::union_of_links(const SelectionCard& card, CardReader& reader, Family family,
                                           Content& content) {
    std::vector<Link> plus, minus;
    for (const ListedId& listed : listed_ids(reader, 1, field_of(family))) {
        const Id id = listed.id < 0 ? -listed.id : listed.id;
        const SelectionCard* found = find(reader, listed.line, family, id);
        if (found != nullptr) (listed.id < 0 ? minus : plus).push_back({found, family});
    }
    if (minus.empty()) return plus;
    if (family != card.family) {
        reader.error(-1, field_of(family), fmt::format("-{}", minus.front().card->id),
                     fmt::format("a negative id has no meaning in {}/{}", keyword_of(card.family), card.type),
                     fmt::format("Take groups away in a {0}{1}", keyword_of(card.family), keyword_of(card.family)));
        return plus;
    }
    const auto all = [&](const std::vector<Link>& links) {
        std::vector<int> found;
        for (const Link& link : links) {
            if (open_.count(link.card) > 0) {
                complain_of_circle(*link.card);
            } else {
                append(found, items(*link.card, family));
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    };
    const std::vector<int> whole = all(plus);
    const std::vector<int> less = all(minus);
    std::vector<int>& to = family == Family::part_group                            ? content.parts
                           : family == Family::node_group || family == Family::box ? content.nodes
                                                                                   : content.shells;
    std::set_difference(whole.begin(), whole.end(), less.begin(), less.end(), std::back_inserter(to));
    return {};
}

void Selector::complain_of_circle(const SelectionCard& card) {
    CardReader where(reading_.deck, *card.card, reading_.model.units, reading_.model.units, reading_.problems);
    where.error(-1, field_of(card.family), fmt::format("{}", card.id),
                "a set does not contain itself, directly or through others", "Remove one of the ids");
}

void Selector::complain_of_type(const SelectionCard& card, CardReader& reader) {
    if (card.type == "SUBMODEL") {  // reading the deck has turned the others into lists
        reader.error(-1, "submodel_ID", reader.text(1, 1, 100), "the deck has no such //SUBMODEL",
                     "Add it, or correct the ids");
        return;
    }
    reader.error(-1, "", card.type, fmt::format("this kind of {} is not supported", keyword_of(card.family)),
                 "Select by parts, shells, nodes or a box");
}

std::vector<int> Selector::nodes_of(const Content& content) {
    std::vector<int> all = content.nodes;
    append_nodes(reading_.model, whole_shells_of(content, ShellKind::any), all);
    sort_once(all, reading_.model.nodes.id.size());
    return all;
}

std::vector<int> Selector::whole_shells_of(const Content& content, ShellKind kind) {
    std::vector<int> all;
    std::copy_if(content.shells.begin(), content.shells.end(), std::back_inserter(all),
                 [&](int shell) { return mesh_.is(kind, shell); });
    const auto append_parts = [&](std::vector<int> parts, ShellKind only) {
        sort_once(parts, reading_.model.parts.size());
        for (const int part : parts)
            mesh_.append_part(only, part, all);
    };
    append_parts(content.parts, kind);
    if (kind != ShellKind::sh3n) append_parts(content.shell_parts, ShellKind::shell);
    if (kind != ShellKind::shell) append_parts(content.sh3n_parts, ShellKind::sh3n);
    return all;
}

std::vector<int> Selector::shells_of(const Content& content, ShellKind kind) {
    std::vector<int> all = whole_shells_of(content, kind);
    std::copy_if(content.bare_shells.begin(), content.bare_shells.end(), std::back_inserter(all),
                 [&](int shell) { return mesh_.is(kind, shell); });
    sort_once(all, reading_.model.shells.size());
    return all;
}

std::vector<int> Selector::parts_of(const Content& content) {
    std::vector<int> all = content.parts;
    append(all, content.bare_parts);
    sort_once(all, reading_.model.parts.size());
    return all;
}

void Selector::check_unused() {
    for (const SelectionCard& card : cards_.all()) {
        if (read_.count(&card) > 0) continue;
        const bool list = PartChoice::knows(card.type) || card.type == "NODE" || card.type == "SHEL" ||
                          card.type == "SH3N" || card.type == "GENE" || card.type.starts_with("GR");
        if (!list) continue;
        CardReader unused(reading_.deck, *card.card, reading_.model.units, reading_.model.units, reading_.problems);
        unused.need({"title"});
        listed_ids(unused, 1, "id");
    }
}

}  // namespace type21
