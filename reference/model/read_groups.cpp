#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

/// A group knows no direction, so a negative id has no meaning in it.
bool positive(CardReader& reader, const ListedId& listed, std::string_view field) {
    if (listed.id > 0) return true;
    reader.error(static_cast<int>(listed.line), field, fmt::format("{}", listed.id),
                 "negative ids are not supported in a node group", "List the members themselves");
    return false;
}

void add_nodes(Reading& reading, CardReader& reader, NodeGroup& group) {
    for (const ListedId& listed : listed_ids(reader, 1, "node_ID")) {
        if (!positive(reader, listed, "node_ID")) continue;
        const auto found = reading.model.nodes.index.find(listed.id);
        if (found != reading.model.nodes.index.end()) {
            group.nodes.push_back(found->second);
        } else {
            reader.error(static_cast<int>(listed.line), "node_ID", fmt::format("{}", listed.id),
                         "there is no node with this id", "Add it to /NODE, or correct the id");
        }
    }
}

void add_parts(Reading& reading, CardReader& reader, NodeGroup& group) {
    std::vector<char> wanted(reading.model.parts.size(), 0);
    for (const ListedId& listed : listed_ids(reader, 1, "part_ID")) {
        if (!positive(reader, listed, "part_ID")) continue;
        const int part = reading.reference(reader, listed.line, "part_ID", listed.id, reading.parts, true);
        if (part >= 0) wanted[static_cast<size_t>(part)] = 1;
    }
    for (const Shell& shell : reading.model.shells) {
        if (wanted[static_cast<size_t>(shell.part)] == 0) continue;
        group.nodes.insert(group.nodes.end(), shell.node.begin(), shell.node.end());
    }
}

void add_surfaces(Reading& reading, CardReader& reader, NodeGroup& group) {
    for (const ListedId& listed : listed_ids(reader, 1, "surf_ID")) {
        if (!positive(reader, listed, "surf_ID")) continue;
        const int index = reading.reference(reader, listed.line, "surf_ID", listed.id, reading.surfaces, true);
        if (index < 0) continue;
        for (const Segment& segment : reading.model.surfaces[static_cast<size_t>(index)].segments) {
            group.nodes.insert(group.nodes.end(), segment.node.begin(), segment.node.end());
        }
    }
}

void sort_once(NodeGroup& group) {
    std::sort(group.nodes.begin(), group.nodes.end());
    group.nodes.erase(std::unique(group.nodes.begin(), group.nodes.end()), group.nodes.end());
}

}  // namespace

/// /GRNOD/NODE, /PART, /SURF and /GRNOD.
void read_groups(Reading& reading) {
    std::vector<NodeGroup>& groups = reading.model.groups;
    const auto next = [&] { return static_cast<int>(groups.size()); };
    const auto start = [&](const CardReader& reader, Id id) -> NodeGroup& {
        NodeGroup& group = groups.emplace_back();
        group.id = id;
        group.title = reader.text(0, 1, 100);
        return group;
    };
    const auto read = [&](Keyword keyword, auto add) {
        reading.each(keyword, reading.groups, next, [&](CardReader& reader, Id id) {
            NodeGroup& group = start(reader, id);
            add(reading, reader, group);
            sort_once(group);
        });
    };
    read(Keyword::group_node, add_nodes);
    read(Keyword::group_part, add_parts);
    read(Keyword::group_surface, add_surfaces);
    const auto append = [&](int index, int from, bool) {
        NodeGroup& group = groups[static_cast<size_t>(index)];
        const std::vector<int> nodes = groups[static_cast<size_t>(from)].nodes;
        group.nodes.insert(group.nodes.end(), nodes.begin(), nodes.end());
    };
    const auto finish = [&](int index) { sort_once(groups[static_cast<size_t>(index)]); };
    read_compounds(reading, Keyword::group_group, reading.groups, next, start, append, finish);
}

}  // namespace type21
