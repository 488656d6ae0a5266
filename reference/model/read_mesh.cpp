#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/text_file.h"
#include "reference/model/degenerate_quad.h"
#include "reference/model/mesh_line.h"
#include "reference/model/numbers.h"
#include "reference/model/reading.h"

namespace type21 {

namespace {

/// Where a node or shell stands: card of the reading, data line of the card.
struct Source {
    std::uint32_t card = 0;
    std::uint32_t line = 0;
};

/// An id has more than one owner: says so at the second.
void complain_of_twin(CardReader& reader, size_t line, std::string_view field, Id id, const std::string& file,
                      int first) {
    reader.error(static_cast<int>(line), field, fmt::format("{}", id),
                 fmt::format("the id is taken in {}:{}", file, first), "Give each its own id, or remove one");
}

bool valid_id(CardReader& reader, size_t line, std::string_view field, Id id) {
    if (id > 0) return true;
    reader.error(static_cast<int>(line), field, reader.text(line, 1, 10), "an id is a positive integer",
                 "Give a number above 0");
    return false;
}

/// The nodes of a line that is not plain, by the reader that says what is wrong with it.
std::optional<PlainNode> node_of(CardReader& reader, size_t line) {
    if (reader.blank(line, 1, 100)) return std::nullopt;
    PlainNode node;
    node.id = reader.integer(line, 1, 10, "node_ID");
    node.position = {reader.real_as_written(line, 11, 30, "X"), reader.real_as_written(line, 31, 50, "Y"),
                     reader.real_as_written(line, 51, 70, "Z")};
    return valid_id(reader, line, "node_ID", node.id) ? std::optional(node) : std::nullopt;
}

size_t lines_of(const Reading& reading, Keyword keyword) {
    size_t count = 0;
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword == keyword) count += entry.card->lines.size();
    }
    return count;
}

/// All nodes in the order of the deck, and where they stand.
std::vector<Source> read_node_lines(Reading& reading, Nodes& nodes) {
    std::vector<Source> sources;
    const size_t count = lines_of(reading, Keyword::node);
    sources.reserve(count);
    nodes.id.reserve(count);
    nodes.position.reserve(count);
    nodes.line.reserve(count);
    for (size_t card = 0; card < reading.cards.size(); ++card) {
        if (reading.cards[card].match.keyword != Keyword::node) continue;
        const std::vector<DataLine>& lines = reading.cards[card].card->lines;
        CardReader reader = reading.reader(*reading.cards[card].card, 1);
        const double factor = conversion(reader.from(), reader.to(), dim::length);
        for (size_t line = 0; line < lines.size(); ++line) {
            std::optional<PlainNode> node = plain_node(lines[line].text());
            if (!node) node = node_of(reader, line);
            if (!node) continue;
            Vec3 position(node->position[0], node->position[1], node->position[2]);
            position *= factor;
            if (!position.allFinite()) {  // the reader says which
                position = {reader.real(line, 11, 30, "X", dim::length), reader.real(line, 31, 50, "Y", dim::length),
                            reader.real(line, 51, 70, "Z", dim::length)};
            }
            nodes.id.push_back(node->id);
            nodes.position.push_back(position);
            nodes.line.push_back(lines[line].number);
            sources.push_back({static_cast<std::uint32_t>(card), static_cast<std::uint32_t>(line)});
        }
        reader.finish();
    }
    return sources;
}

/// Says that the id of the second place is taken by the first.
void complain_of_twins(Reading& reading, std::string_view field, Id id, const Source& first, const Source& second) {
    const Card& card = *reading.cards[second.card].card;
    CardReader reader(reading.deck, card, reading.model.input_units, reading.model.units, reading.problems);
    const Place place = reading.deck.place(reading.cards[first.card].card->lines[first.line]);
    complain_of_twin(reader, second.line, field, id, place.file, place.line);
}

/// Nodes in the order of their ids, each id once.
void sort_nodes(Reading& reading, Nodes& nodes, const std::vector<Source>& sources) {
    std::vector<std::uint32_t> order(nodes.id.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return nodes.id[a] < nodes.id[b]; });
    Nodes sorted;
    sorted.id.reserve(order.size());
    sorted.position.reserve(order.size());
    sorted.line.reserve(order.size());
    std::uint32_t before = 0;
    for (const std::uint32_t i : order) {
        if (!sorted.id.empty() && sorted.id.back() == nodes.id[i]) {
            complain_of_twins(reading, "node_ID", nodes.id[i], sources[before], sources[i]);
            continue;
        }
        sorted.id.push_back(nodes.id[i]);
        sorted.position.push_back(nodes.position[i]);
        sorted.line.push_back(nodes.line[i]);
        before = i;
    }
    nodes = std::move(sorted);
}

void read_nodes(Reading& reading) {
    Nodes& nodes = reading.model.nodes;
    const std::vector<Source> sources = read_node_lines(reading, nodes);
    const bool ascending =
        std::adjacent_find(nodes.id.begin(), nodes.id.end(), std::greater_equal<>()) == nodes.id.end();
    if (!ascending) sort_nodes(reading, nodes, sources);
    nodes.index.reserve(nodes.id.size());
    for (size_t i = 0; i < nodes.id.size(); ++i)
        nodes.index.emplace(nodes.id[i], static_cast<int>(i));
}

/// Node indices of a shell; false when one is missing or the shape is none.
bool read_corners(Reading& reading, CardReader& reader, size_t line, int corners, Shell& shell) {
    std::array<Id, 4> ids{};
    for (int corner = 0; corner < corners; ++corner) {
        ids[static_cast<size_t>(corner)] = reader.integer(line, 11 + 10 * corner, 20 + 10 * corner, "node_ID");
    }
    if (!mend_quad(reader, line, ids, "shell", shell.id)) return false;
    const bool triangle = ids[3] == ids[2];
    bool complete = true;
    for (size_t corner = 0; corner < 4; ++corner) {
        const auto found = reading.model.nodes.index.find(ids[corner]);
        if (found != reading.model.nodes.index.end()) {
            shell.node[corner] = found->second;
        } else {
            complete = false;
            if (corner == 3 && triangle) continue;
            reader.error(static_cast<int>(line), "node_ID", fmt::format("{}", ids[corner]),
                         "there is no node with this id", "Add it to /NODE, or correct the id");
        }
    }
    return complete;
}

/// Thickness of a shell: its own, else that of its property. Only a void property may have none.
double thickness_of(Reading& reading, CardReader& reader, size_t line, int part) {
    const double own = reader.real(line, 81, 100, "Thick", dim::length);
    if (own < 0) {
        reader.error(static_cast<int>(line), "Thick", quantity(reader, own, dim::length), "a thickness is not negative",
                     "Give 0 for that of the property");
    }
    if (own != 0 || part < 0) return own;
    const int index = reading.model.parts[static_cast<size_t>(part)].property;
    if (index < 0) return 0;
    const Property& property = reading.model.properties[static_cast<size_t>(index)];
    if (property.thickness == 0 && property.kind == PropertyKind::shell) {
        reader.error(static_cast<int>(line), "Thick", quantity(reader, 0, dim::length),
                     fmt::format("a shell has a thickness; neither the shell nor property {} gives one", property.id),
                     "Give Thick in the /PROP/SHELL card");
    }
    return property.thickness;
}

/// A plain line whose shell needs no word: four or three different nodes that are there, and a thickness.
bool read_plain_shell(const Reading& reading, const PlainShell& line, double factor, int part, Shell& shell) {
    const auto& n = line.node;
    const bool triangle = n[3] == n[2];
    if (part < 0 || n[0] == n[1] || n[1] == n[2] || n[0] == n[2] || (!triangle && (n[0] == n[3] || n[1] == n[3])))
        return false;
    for (size_t corner = 0; corner < 4; ++corner) {
        const auto found = reading.model.nodes.index.find(n[corner]);
        if (found == reading.model.nodes.index.end()) return false;
        shell.node[corner] = found->second;
    }
    shell.thickness = line.thickness * factor;
    bool may_be_zero = false;
    if (shell.thickness == 0) {
        const int index = reading.model.parts[static_cast<size_t>(part)].property;
        if (index < 0) return false;
        const Property& property = reading.model.properties[static_cast<size_t>(index)];
        shell.thickness = property.thickness;
        may_be_zero = property.kind != PropertyKind::shell;
    }
    shell.id = line.id;
    shell.part = part;
    return (shell.thickness > 0 || (shell.thickness == 0 && may_be_zero)) && std::isfinite(shell.thickness);
}

/// The same by the reader that says what is wrong. The id, where it is one, is in the shell.
bool read_shell(Reading& reading, CardReader& reader, size_t line, int corners, std::string_view field, int part,
                Shell& shell) {
    shell = {};
    shell.id = reader.integer(line, 1, 10, field);
    if (!valid_id(reader, line, field, shell.id)) {
        reader.skip(line, 1, 101);
        return false;
    }
    shell.part = part;
    shell.thickness = thickness_of(reading, reader, line, part);
    reader.unused(line, 61, 80, 20);  // the angle of the material's axes
    return read_corners(reading, reader, line, corners, shell) && part >= 0;
}

/// Ids that two shells have; where the ids ascend in the deck there are none.
void check_twins(Reading& reading, Keyword keyword, std::string_view field) {
    std::vector<std::pair<Id, Source>> ids;
    ids.reserve(lines_of(reading, keyword));
    for (size_t card = 0; card < reading.cards.size(); ++card) {
        if (reading.cards[card].match.keyword != keyword) continue;
        const std::vector<DataLine>& lines = reading.cards[card].card->lines;
        for (size_t line = 0; line < lines.size(); ++line) {
            Id id = 0;
            const std::string_view word = trimmed(lines[line].text().substr(0, 10));
            if (parse_integer(word, id) == NumberFault::none && id > 0)
                ids.push_back({id, {static_cast<std::uint32_t>(card), static_cast<std::uint32_t>(line)}});
        }
    }
    std::stable_sort(ids.begin(), ids.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (size_t i = 1; i < ids.size(); ++i) {
        if (ids[i].first == ids[i - 1].first)
            complain_of_twins(reading, field, ids[i].first, ids[i - 1].second, ids[i].second);
    }
}

/// /SHELL/part and /SH3N/part: corners from column 11 on, the thickness in columns 81 to 100 of both.
void read_shells(Reading& reading, Keyword keyword, int corners, std::string_view field) {
    bool ascending = true;
    Id before = 0;
    reading.model.shells.reserve(reading.model.shells.size() + lines_of(reading, keyword));
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword != keyword) continue;
        CardReader reader = reading.reader(*entry.card, 2);
        const double factor = conversion(reader.from(), reader.to(), dim::length);
        const std::optional<Id> part_id = id_of(*entry.card, 1, reader);
        const int part =
            part_id ? reading.reference(reader, keyword_line, "part_ID", *part_id, reading.parts, true) : -1;
        for (size_t line = 0; line < reader.line_count(); ++line) {
            Shell shell;
            const auto plain = plain_shell(entry.card->lines[line].text(), corners);
            bool good = plain && read_plain_shell(reading, *plain, factor, part, shell);
            if (!good) {
                if (reader.blank(line, 1, 100)) continue;
                good = read_shell(reading, reader, line, corners, field, part, shell);
            }
            ascending = ascending && shell.id > before;
            before = shell.id;
            if (good) reading.model.shells.push_back(shell);
        }
        reader.finish();
    }
    if (!ascending) check_twins(reading, keyword, field);
}

}  // namespace

/// /NODE, /SHELL and /SH3N. All shells of four nodes come before those of three, as in Radioss.
void read_mesh(Reading& reading) {
    const auto forget = [&](std::string_view word) {
        if (reading.forget) reading.forget(word);
    };
    read_nodes(reading);
    forget("NODE");
    read_shells(reading, Keyword::shell, 4, "shell_ID");
    forget("SHELL");
    reading.first_sh3n = static_cast<int>(reading.model.shells.size());
    read_shells(reading, Keyword::sh3n, 3, "sh3n_ID");
    forget("SH3N");
}

}  // namespace type21
