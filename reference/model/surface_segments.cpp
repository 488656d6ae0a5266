#include <algorithm>

#include <fmt/format.h>

#include "reference/model/selector.h"

namespace type21 {

struct Selector::SignedLink {
    const SelectionCard* card = nullptr;
    bool turned = false;
};

Segment reversed(const Segment& segment) {
    Segment other = segment;
    if (segment.is_triangle()) {
        std::swap(other.node[0], other.node[1]);
    } else {
        std::reverse(other.node.begin(), other.node.end());
    }
    return other;
}

std::vector<Segment> Selector::segments(const SelectionCard& card) {
    struct Frame {
        SignedLink at;
        std::vector<SignedLink> links;
        size_t next = 0;
    };
    std::vector<Segment> found;
    std::vector<Frame> stack;
    const size_t most = most_segments();
    size_t steps = 0;
    const auto enter = [&](const SignedLink& next) {
        if (open_.count(next.card) > 0) {
            complain_of_circle(*next.card);
            return true;
        }
        if (++steps + found.size() > most) return false;
        if (next.card->family == Family::set) {
            append_set(*next.card, next.turned, found);
            return true;
        }
        open_.insert(next.card);
        stack.push_back({next, open_surface(*next.card, next.turned, found), 0});
        return true;
    };
    bool goes_on = enter({&card, false});
    while (!stack.empty()) {
        Frame& frame = stack.back();
        if (!goes_on || frame.next == frame.links.size()) {
            open_.erase(frame.at.card);
            stack.pop_back();
        } else {
            goes_on = enter(frame.links[frame.next++]);
        }
    }
    if (!goes_on) {
        CardReader where(reading_.deck, *card.card, reading_.model.units, reading_.model.units, reading_.problems);
        where.error(-1, "surf_ID", fmt::format("{}", card.id), fmt::format("a surface has at most {} segments", most),
                    "Look for a surface that is listed again and again");
        found.clear();
    }
    return found;
}

/// Far more than any deck has that does not list the same surface again and again.
size_t Selector::most_segments() const {
    size_t lines = 1000;
    for (const SelectionCard& card : cards_.all())
        lines += 1 + card.card->lines.size();
    return 16 * (reading_.model.shells.size() + lines);
}

/// The shells of the set, then the segments that it lists.
void Selector::append_set(const SelectionCard& card, bool turned, std::vector<Segment>& segments) {
    const Content content = gather(card);
    std::vector<SignedShell> shells;
    for (const int shell : shells_of(content, ShellKind::any))
        shells.emplace_back(shell, false);
    append_shells(std::move(shells), turned, segments);
    for (const Segment& segment : content.segments)
        segments.push_back(turned ? reversed(segment) : segment);
}

std::vector<Selector::SignedLink> Selector::open_surface(const SelectionCard& card, bool turned,
                                                         std::vector<Segment>& segments) {
    CardReader card_reader = reader(card);
    card_reader.need({"title"});
    std::vector<SignedLink> links = open_surface(card, card_reader, turned, segments);
    card_reader.finish();
    return links;
}

std::vector<Selector::SignedLink> Selector::open_surface(const SelectionCard& card, CardReader& card_reader,
                                                         bool turned, std::vector<Segment>& segments) {
    if (card.type == "SURF") {
        std::vector<SignedLink> links;
        for (const ListedId& listed : listed_ids(card_reader, 1, "surf_ID")) {
            const bool minus = listed.id < 0;
            const SelectionCard* other =
                find(card_reader, listed.line, Family::surface, minus ? -listed.id : listed.id);
            if (other != nullptr) links.push_back({other, minus != turned});
        }
        return links;
    }
    if (card.type == "SEG") {
        std::vector<Segment> own;
        for (size_t line = 1; line < card_reader.line_count(); ++line) {
            if (card_reader.blank(line, 1, 60)) continue;
            card_reader.unused(line, 1, 10, 10);  // the number of the segment
            std::array<Id, 4> ids{};
            for (int corner = 0; corner < 4; ++corner)
                ids[static_cast<size_t>(corner)] =
                    card_reader.integer(line, 11 + 10 * corner, 20 + 10 * corner, "node_ID");
            append_segment(card_reader, line, ids, own);
        }
        for (const Segment& segment : own)
            segments.push_back(turned ? reversed(segment) : segment);
        return {};
    }
    append_shells(listed_shells(card, card_reader), turned, segments);
    return {};
}

void Selector::append_segment(CardReader& reader, size_t line, const std::array<Id, 4>& ids,
                              std::vector<Segment>& segments) {
    if (!finder_) finder_.emplace(reading_.model);
    if (const std::optional<Segment> segment = read_segment(reading_.model, reader, line, ids, *finder_))
        segments.push_back(*segment);
}

/// What the ids of a /SURF/PART, MAT, PROP, SUBSET, GRPART, GRSHEL, GRSH3N, BOX or BOX2 card stand for; a negative id
/// turns its shells round.
std::vector<Selector::SignedShell> Selector::listed_shells(const SelectionCard& card, CardReader& reader) {
    std::vector<SignedShell> shells;
    const bool of_parts = PartChoice::knows(card.type);
    const bool of_box = card.type == "BOX" || card.type == "BOX2";
    const Family family = card.type == "GRSHEL"   ? Family::shell_group
                          : card.type == "GRSH3N" ? Family::sh3n_group
                          : card.type == "GRPART" ? Family::part_group
                                                  : Family::box;
    if (!of_parts && !of_box && family == Family::box) {
        complain_of_type(card, reader);
        return {};
    }
    for (const ListedId& listed : listed_ids(reader, 1, of_parts ? "part_ID" : field_of(family))) {
        const bool minus = listed.id < 0;
        const Id id = minus ? -listed.id : listed.id;
        std::vector<int> found;
        if (of_parts) {
            std::vector<int> parts;
            part_choice_.append(reader, listed.line, card.type, id, parts);
            for (const int part : parts)
                mesh_.append_part(ShellKind::any, part, found);
        } else if (const SelectionCard* chosen = find(reader, listed.line, family, id)) {
            if (of_box) {
                append_boxed(*chosen, ShellKind::any, card.type == "BOX", found);
            } else {
                found = this->shells(*chosen, family == Family::shell_group  ? ShellKind::shell
                                              : family == Family::sh3n_group ? ShellKind::sh3n
                                                                             : ShellKind::any);
            }
        }
        for (const int shell : found)
            shells.emplace_back(shell, minus);
    }
    return shells;
}

/// In the order of the deck, each shell once; of several listings the last one gives the sense.
void Selector::append_shells(std::vector<SignedShell> shells, bool turned, std::vector<Segment>& segments) const {
    const auto by_index = [](const SignedShell& a, const SignedShell& b) { return a.first < b.first; };
    if (!std::is_sorted(shells.begin(), shells.end(), by_index))
        std::stable_sort(shells.begin(), shells.end(), by_index);
    for (size_t i = 0; i < shells.size(); ++i) {
        if (i + 1 < shells.size() && shells[i + 1].first == shells[i].first) continue;
        const auto [index, minus] = shells[i];
        const Segment segment{reading_.model.shells[static_cast<size_t>(index)].node, index};
        segments.push_back(minus != turned ? reversed(segment) : segment);
    }
}

}  // namespace type21
