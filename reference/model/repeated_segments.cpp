#include "reference/model/repeated_segments.h"

#include <algorithm>

#include <fmt/format.h>

#include "reference/model/card_reading.h"

namespace type21 {

namespace {

void note(const CardValidator& validator, Surface& surface, std::string_view field, std::string_view what) {
    const std::vector<int> repeated = repeated_segments(surface);
    if (repeated.empty()) return;
    const bool once = !validator.reading().repeated_segments_count;
    std::vector<Id> numbers;
    numbers.reserve(repeated.size());
    for (const int rank : repeated)
        numbers.push_back(rank + 1);
    validator.warning_with(
        field,
        fmt::format("{} segment{}: no. {}", repeated.size(), repeated.size() == 1 ? "" : "s", first_few(numbers)),
        once ? fmt::format("have the nodes of an earlier segment: each counts once in {}", what)
             : fmt::format("D41: have the nodes of an earlier segment, and count again in {}", what),
        "Take them out of the surface");
    if (once) surface.repeated = repeated;
}

}  // namespace

std::array<int, 4> sorted_nodes(const Segment& segment) {
    std::array<int, 4> nodes = segment.node;
    if (segment.is_triangle()) nodes[3] = -1;
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

std::vector<int> repeated_segments(const Surface& surface) {
    // Segments side by side by their lowest node: those with equal nodes are then close together.
    const auto& segments = surface.segments;
    int highest = -1;
    for (const Segment& segment : segments)
        highest = std::max(highest, *std::max_element(segment.node.begin(), segment.node.end()));
    std::vector<int> first(static_cast<size_t>(highest + 2), 0);
    const auto lowest = [](const Segment& segment) {
        return static_cast<size_t>(*std::min_element(segment.node.begin(), segment.node.end()));
    };
    for (const Segment& segment : segments)
        ++first[lowest(segment) + 1];
    for (size_t node = 1; node < first.size(); ++node)
        first[node] += first[node - 1];
    std::vector<int> order(segments.size());
    std::vector<int> next(first.begin(), first.end());
    for (size_t rank = 0; rank < segments.size(); ++rank)
        order[static_cast<size_t>(next[lowest(segments[rank])]++)] = static_cast<int>(rank);

    std::vector<int> repeated;
    std::vector<std::pair<std::array<int, 4>, int>> at_node;
    for (size_t node = 0; node + 1 < first.size(); ++node) {
        at_node.clear();
        for (int i = first[node]; i < first[node + 1]; ++i) {
            const int rank = order[static_cast<size_t>(i)];
            at_node.emplace_back(sorted_nodes(segments[static_cast<size_t>(rank)]), rank);
        }
        std::sort(at_node.begin(), at_node.end());
        for (size_t i = 1; i < at_node.size(); ++i)
            if (at_node[i].first == at_node[i - 1].first) repeated.push_back(at_node[i].second);
    }
    std::sort(repeated.begin(), repeated.end());
    return repeated;
}

/// @manual field surf_IDs, surf_IDm; departure D41
void note_repeated_segments(const CardValidator& validator, Model& model) {
    const Interface& it = validator.interface;
    if (it.secondary_surface >= 0)
        note(validator, model.surfaces[static_cast<size_t>(it.secondary_surface)], "surf_IDs", "nodal areas");
    if (it.main_surface >= 0)
        note(validator, model.surfaces[static_cast<size_t>(it.main_surface)], "surf_IDm", "nodal normals");
}

}  // namespace type21
