#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "reference/model/degenerate_quad.h"
#include "reference/model/reading.h"

namespace type21 {

namespace {

struct NodeLine {
    Id id = 0;
    Vec3 position = Vec3::Zero();
    const Card* card = nullptr;
    size_t line = 0;
    size_t unit_position = 1;
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

std::vector<NodeLine> node_lines(Reading& reading) {
    std::vector<NodeLine> read;
    size_t count = 0;
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword == Keyword::node) count += entry.card->lines.size();
    }
    read.reserve(count);
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword != Keyword::node) continue;
        CardReader reader = reading.reader(*entry.card, 1);
        for (size_t line = 0; line < reader.line_count(); ++line) {
            if (reader.blank(line, 1, 100)) continue;
            NodeLine node;
            node.card = entry.card;
            node.line = line;
            node.id = reader.integer(line, 1, 10, "node_ID");
            node.position.x() = reader.real(line, 11, 30, "X", dim::length);
            node.position.y() = reader.real(line, 31, 50, "Y", dim::length);
            node.position.z() = reader.real(line, 51, 70, "Z", dim::length);
            if (valid_id(reader, line, "node_ID", node.id)) read.push_back(node);
        }
    }
    return read;
}

void read_nodes(Reading& reading) {
    std::vector<NodeLine> read = node_lines(reading);
    std::stable_sort(read.begin(), read.end(), [](const NodeLine& a, const NodeLine& b) { return a.id < b.id; });
    Nodes& nodes = reading.model.nodes;
    nodes.id.reserve(read.size());
    nodes.position.reserve(read.size());
    nodes.line.reserve(read.size());
    nodes.index.reserve(read.size());
    const NodeLine* before = nullptr;
    for (const NodeLine& node : read) {
        const DataLine& place = node.card->lines[node.line];
        if (before != nullptr && before->id == node.id) {
            CardReader reader = reading.reader(*node.card, 1);
            const Place first = reading.deck.place(before->card->lines[before->line]);
            complain_of_twin(reader, node.line, "node_ID", node.id, first.file, first.line);
            continue;
        }
        nodes.index.emplace(node.id, nodes.size());
        nodes.id.push_back(node.id);
        nodes.position.push_back(node.position);
        nodes.line.push_back(place.number);
        before = &node;
    }
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

struct ShellPlace {
    Id id = 0;
    const Card* card = nullptr;
    size_t line = 0;
};

void check_twins(Reading& reading, std::vector<ShellPlace> places, std::string_view field) {
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    for (size_t i = 1; i < places.size(); ++i) {
        if (places[i].id != places[i - 1].id) continue;
        CardReader reader(reading.deck, *places[i].card, reading.model.input_units, reading.model.units,
                          reading.problems);
        const Place first = reading.deck.place(places[i - 1].card->lines[places[i - 1].line]);
        complain_of_twin(reader, places[i].line, field, places[i].id, first.file, first.line);
    }
}

/// /SHELL/part and /SH3N/part: corners from column 11 on, the thickness in columns 81 to 100 of both.
void read_shells(Reading& reading, Keyword keyword, int corners, std::string_view field) {
    std::vector<ShellPlace> places;
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword != keyword) continue;
        CardReader reader = reading.reader(*entry.card, 2);
        const std::optional<Id> part_id = id_of(*entry.card, 1, reader);
        const int part =
            part_id ? reading.reference(reader, keyword_line, "part_ID", *part_id, reading.parts, true) : -1;
        for (size_t line = 0; line < reader.line_count(); ++line) {
            if (reader.blank(line, 1, 100)) continue;
            Shell shell;
            shell.id = reader.integer(line, 1, 10, field);
            if (!valid_id(reader, line, field, shell.id)) continue;
            places.push_back({shell.id, entry.card, line});
            shell.part = part;
            shell.thickness = thickness_of(reading, reader, line, part);
            const bool complete = read_corners(reading, reader, line, corners, shell);
            if (complete && part >= 0) reading.model.shells.push_back(shell);
        }
    }
    check_twins(reading, std::move(places), field);
}

}  // namespace

/// /NODE, /SHELL and /SH3N. All shells of four nodes come before those of three, as in Radioss.
void read_mesh(Reading& reading) {
    read_nodes(reading);
    read_shells(reading, Keyword::shell, 4, "shell_ID");
    read_shells(reading, Keyword::sh3n, 3, "sh3n_ID");
}

}  // namespace type21
