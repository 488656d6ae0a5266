#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "reference/model/box.h"
#include "reference/model/selector.h"

namespace type21 {

namespace {

ShellKind kind_of(Family family) {
    return family == Family::shell_group ? ShellKind::shell : ShellKind::sh3n;
}

/// A list of members has no place for a minus sign.
bool positive(CardReader& reader, const ListedId& listed, std::string_view field) {
    if (listed.id > 0) return true;
    reader.error(static_cast<int>(listed.line), field, fmt::format("{}", listed.id),
                 "negative ids are not supported in a list of members", "List the members themselves");
    return false;
}

}  // namespace

std::vector<IdRange> id_ranges(CardReader& reader, bool with_step) {
    std::vector<IdRange> ranges;
    const int width = with_step ? 30 : 20;
    for (size_t line = 1; line < reader.line_count(); ++line) {
        for (int column = 1; column + width <= 101; column += width) {
            if (reader.blank(line, column, column + width - 1)) continue;
            IdRange range;
            range.first = reader.integer(line, column, column + 9, "Ifirst");
            range.last = reader.integer(line, column + 10, column + 19, "Ilast");
            if (with_step) range.step = reader.integer(line, column + 20, column + 29, "Incr");
            if (range.first == 0 && range.last == 0) continue;
            if (range.first > 0 && range.last >= range.first && range.step > 0) {
                ranges.push_back(range);
                continue;
            }
            reader.error(static_cast<int>(line), "Ifirst", fmt::format("{} {} {}", range.first, range.last, range.step),
                         "a range has a first id above 0, a last one that is not below it, and a step above 0",
                         "Give first and last id, ten columns each, and the step in /GEN_INCR");
        }
    }
    return ranges;
}

std::vector<Link> Selector::open_node_group(const SelectionCard& card, CardReader& reader, Content& content) {
    if (card.type == "NODE" || card.type == "NODENS") {
        for (const ListedId& listed : listed_ids(reader, 1, "node_ID")) {
            if (positive(reader, listed, "node_ID")) append_node(reader, listed.line, listed.id, content.nodes);
        }
    } else if (card.type == "GENE" || card.type == "GEN_INCR") {
        for (const IdRange& range : id_ranges(reader, card.type == "GEN_INCR"))
            append_node_range(range.first, range.last, range.step, content.nodes);
    } else if (card.type == "SURF") {
        for (const ListedId& listed : listed_ids(reader, 1, "surf_ID")) {
            if (!positive(reader, listed, "surf_ID")) continue;
            const SelectionCard* surface = find(reader, listed.line, Family::surface, listed.id);
            if (surface == nullptr) continue;
            const std::vector<int> found = nodes(*surface);
            content.nodes.insert(content.nodes.end(), found.begin(), found.end());
        }
    } else if (card.type == "BOX") {
        return union_of_links(card, reader, Family::box, content);
    } else if (card.type == "GRNOD") {
        return union_of_links(card, reader, Family::node_group, content);
    } else if (card.type == "GRSHEL") {
        return union_of_links(card, reader, Family::shell_group, content);
    } else if (card.type == "GRSH3N") {
        return union_of_links(card, reader, Family::sh3n_group, content);
    } else if (card.type == "GRPART") {
        return union_of_links(card, reader, Family::part_group, content);
    } else if (PartChoice::knows(card.type)) {
        append_listed_parts(card, reader, content.parts);
    } else {
        complain_of_type(card, reader);
    }
    return {};
}

std::vector<Link> Selector::open_shell_group(const SelectionCard& card, CardReader& reader, Content& content) {
    const ShellKind kind = kind_of(card.family);
    const bool shell = kind == ShellKind::shell;
    if (card.type == (shell ? "SHEL" : "SH3N") || card.type == (shell ? "SHELL" : "TRIA")) {
        const std::string_view field = shell ? "shell_ID" : "sh3n_ID";
        for (const ListedId& listed : listed_ids(reader, 1, field)) {
            if (positive(reader, listed, field)) append_shell(reader, listed.line, kind, listed.id, content.shells);
        }
    } else if (card.type == "GENE" || card.type == "GEN_INCR") {
        for (const IdRange& range : id_ranges(reader, card.type == "GEN_INCR"))
            mesh_.append_range(kind, range.first, range.last, range.step, content.shells);
    } else if (card.type == "BOX" || card.type == "BOX2") {
        for (const ListedId& listed : listed_ids(reader, 1, "box_ID")) {
            if (!positive(reader, listed, "box_ID")) continue;
            const SelectionCard* box = find(reader, listed.line, Family::box, listed.id);
            if (box != nullptr) append_boxed(*box, kind, card.type == "BOX", content.shells);
        }
    } else if (card.type == (shell ? "GRSHEL" : "GRSH3N")) {
        return union_of_links(card, reader, card.family, content);
    } else if (PartChoice::knows(card.type)) {
        append_listed_parts(card, reader, shell ? content.shell_parts : content.sh3n_parts);
    } else {
        complain_of_type(card, reader);
    }
    return {};
}

std::vector<Link> Selector::open_part_group(const SelectionCard& card, CardReader& reader, Content& content) {
    if (card.type == "GRPART") return union_of_links(card, reader, Family::part_group, content);
    if (card.type == "GENE" || card.type == "GEN_INCR") {
        for (const IdRange& range : id_ranges(reader, card.type == "GEN_INCR"))
            append_part_range(range.first, range.last, range.step, content.parts);
    } else if (PartChoice::knows(card.type)) {
        append_listed_parts(card, reader, content.parts);
    } else {
        complain_of_type(card, reader);
    }
    return {};
}

std::vector<Link> Selector::open_box(const SelectionCard& card, CardReader& reader, Content& content) {
    if (card.type == "BOX") return union_of_links(card, reader, Family::box, content);
    if (card.type != "RECTA" && card.type != "CYLIN" && card.type != "SPHER") {
        complain_of_type(card, reader);
        return {};
    }
    if (!placed_) {
        reader.error(-1, "box_ID", fmt::format("{}", card.id),
                     "a /TRANSFORM moves its nodes before boxes are filled, so that its group cannot be given by a box",
                     "List the nodes, parts or shells");
        return {};
    }
    const Box box = read_box(reading_, reader, card.type);
    for (size_t node = 0; node < positions_.size(); ++node) {
        if (box.contains(positions_[node])) content.nodes.push_back(static_cast<int>(node));
    }
    return {};
}

void Selector::append_listed_parts(const SelectionCard& card, CardReader& reader, std::vector<int>& parts) {
    for (const ListedId& listed : listed_ids(reader, 1, "part_ID")) {
        if (positive(reader, listed, "part_ID")) part_choice_.append(reader, listed.line, card.type, listed.id, parts);
    }
}

void Selector::append_node(CardReader& reader, size_t line, Id id, std::vector<int>& nodes) {
    const auto& index = reading_.model.nodes.index;
    if (const auto found = index.find(id); found != index.end()) {
        nodes.push_back(found->second);
    } else {
        reader.error(static_cast<int>(line), "node_ID", fmt::format("{}", id), "there is no node with this id",
                     "Add it to /NODE, or correct the id");
    }
}

void Selector::append_shell(CardReader& reader, size_t line, ShellKind kind, Id id, std::vector<int>& shells) {
    const std::string keyword = kind == ShellKind::shell ? "/SHELL" : "/SH3N";
    if (const int found = mesh_.shell(kind, id); found >= 0) {
        shells.push_back(found);
    } else {
        reader.error(static_cast<int>(line), kind == ShellKind::shell ? "shell_ID" : "sh3n_ID", fmt::format("{}", id),
                     fmt::format("there is no {} with this id", keyword),
                     fmt::format("Add it to a {} card, or correct the id", keyword));
    }
}

void Selector::append_node_range(Id first, Id last, Id step, std::vector<int>& nodes) const {
    const std::vector<Id>& ids = reading_.model.nodes.id;
    auto node = std::lower_bound(ids.begin(), ids.end(), first);
    for (; node != ids.end() && *node <= last; ++node) {
        if ((*node - first) % step == 0) nodes.push_back(static_cast<int>(node - ids.begin()));
    }
}

void Selector::append_part_range(Id first, Id last, Id step, std::vector<int>& parts) const {
    for (size_t i = 0; i < reading_.model.parts.size(); ++i) {
        const Id id = reading_.model.parts[i].id;
        if (id >= first && id <= last && (id - first) % step == 0) parts.push_back(static_cast<int>(i));
    }
}

void Selector::append_boxed(const SelectionCard& box, ShellKind kind, bool whole, std::vector<int>& shells) {
    std::vector<char> inside(positions_.size(), 0);
    for (const int node : nodes(box))
        inside[static_cast<size_t>(node)] = 1;
    const std::vector<Shell>& all = reading_.model.shells;
    for (size_t i = 0; i < all.size(); ++i) {
        if (!mesh_.is(kind, static_cast<int>(i))) continue;
        const auto in_box = [&](int node) { return inside[static_cast<size_t>(node)] != 0; };
        const auto& corners = all[i].node;  // a triangle repeats its third
        if (whole ? std::all_of(corners.begin(), corners.end(), in_box)
                  : std::any_of(corners.begin(), corners.end(), in_box))
            shells.push_back(static_cast<int>(i));
    }
}

}  // namespace type21
