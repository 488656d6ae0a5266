/// @file Main nodes and the checks of both sides.
#include "reference/model/tool_side.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/secondary_side.h"
#include "reference/model/sourced_rules.h"

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

const RigidBody& tool(const CardValidator& validator) {
    return validator.model.rigid_bodies[at(validator.interface.tool)];
}
const Surface& main_surface(const CardValidator& validator) {
    return validator.model.surfaces[at(validator.interface.main_surface)];
}
const Surface& secondary_surface(const CardValidator& validator) {
    return validator.model.surfaces[at(validator.interface.secondary_surface)];
}

/// The three rotations of the main node are fixed, by one /BCS or by several together.
bool rotations_fixed(const Model& model, int node) {
    std::array<bool, 6> fixed{};
    for (const BoundaryCondition& condition : model.boundary_conditions) {
        if (condition.group < 0) continue;
        const auto& nodes = model.groups[at(condition.group)].nodes;
        if (!std::binary_search(nodes.begin(), nodes.end(), node)) continue;
        for (size_t direction = 0; direction < 6; ++direction)
            fixed[direction] = fixed[direction] || condition.fixed[direction];
    }
    return fixed[3] && fixed[4] && fixed[5];
}

std::vector<Id> ids(const Model& model, const std::vector<int>& nodes) {
    std::vector<Id> out;
    out.reserve(nodes.size());
    for (const int node : nodes)
        out.push_back(model.nodes.id[at(node)]);
    return out;
}

std::string node_list(const Model& model, const std::vector<int>& nodes) {
    return fmt::format("{} nodes: {}", nodes.size(), first_few(ids(model, nodes)));
}

/// @manual field IDrby, surf_IDm
void check_main_nodes(const CardValidator& validator, const std::vector<int>& main) {
    std::vector<int> outside;
    const auto& body = tool(validator).nodes;
    std::set_difference(main.begin(), main.end(), body.begin(), body.end(), std::back_inserter(outside));
    if (outside.empty()) return;
    validator.error_with(
        "surf_IDm", node_list(validator.model, outside),
        fmt::format("every main node must be a secondary node of the rigid body {}", tool(validator).id),
        "Add these nodes to the node group of the /RBODY, or take their segments out of the main surface");
}

/// Such a node could only follow the tool. Those on both sides have been reported already.
void check_secondary_nodes(const CardValidator& validator, const std::vector<int>& secondary,
                           const std::vector<int>& shared) {
    std::vector<int> own;
    std::vector<int> inside;
    std::set_difference(secondary.begin(), secondary.end(), shared.begin(), shared.end(), std::back_inserter(own));
    const RigidBody& body = tool(validator);
    std::copy_if(own.begin(), own.end(), std::back_inserter(inside), [&](int node) {
        return node == body.main_node || std::binary_search(body.nodes.begin(), body.nodes.end(), node);
    });
    if (inside.empty()) return;
    validator.error_with("surf_IDs", node_list(validator.model, inside),
                         fmt::format("a secondary node cannot belong to the tool's rigid body {}", body.id),
                         "Take these nodes out of the /RBODY or out of the secondary surface");
}

/// @manual field surf_IDm; comment 1
void check_elements(const CardValidator& validator, std::string_view field, const Surface& surface,
                    std::string_view consequence) {
    std::vector<Id> ranks;
    for (size_t rank = 0; rank < surface.segments.size(); ++rank)
        if (surface.segments[rank].shell < 0) ranks.push_back(static_cast<Id>(rank) + 1);
    if (ranks.empty()) return;
    validator.warning_with(field, fmt::format("{} segments: no. {}", ranks.size(), first_few(ranks)),
                           fmt::format("lie on no element: {}", consequence),
                           "Give the surface from parts, or put a void shell under them");
}

/// Neither a projection nor a normal exists on a segment without area.
void check_areas(const CardValidator& validator) {
    constexpr double rounding = 1e-14;  // of the squared size: what the differences of coordinates leave of a zero
    const auto& x = validator.model.nodes.position;
    std::vector<Id> ranks;
    const auto& segments = main_surface(validator).segments;
    for (size_t rank = 0; rank < segments.size(); ++rank) {
        const auto& n = segments[rank].node;
        const Vec3 first = x[at(n[2])] - x[at(n[0])];
        const Vec3 second = x[at(n[3])] - x[at(n[1])];
        if (first.cross(second).norm() <= rounding * std::max(first.squaredNorm(), second.squaredNorm()))
            ranks.push_back(static_cast<Id>(rank) + 1);
    }
    if (ranks.empty()) return;
    validator.error_with("surf_IDm", fmt::format("{} segments: no. {}", ranks.size(), first_few(ranks)),
                         "a main segment must have an area",
                         "Mend the nodes of these segments or take them out of the surface");
}

}  // namespace

/// @manual field surf_IDs, surf_IDm
void refuse_shared_nodes(const CardValidator& validator, const std::string& nodes) {
    validator.error_with("surf_IDs", nodes, "a node cannot be a secondary and a main node at the same time",
                         "Take them out of one of the surfaces");
}

/// @manual field Dampr
void build_tool_side(const CardValidator& validator) {
    Interface& it = validator.interface;
    it.main_nodes = surface_nodes(main_surface(validator));
    it.tool_rotates = !rotations_fixed(validator.model, tool(validator).main_node);
    if (it.dampr != 0 && !it.tool_rotates) {
        validator.warning("Dampr", "has no effect: the rotations of the tool's main node are fixed by /BCS",
                          "Leave it blank to keep the deck clear");
        take_by_rule(it.dampr, 0.0, "the rotations of the tool are fixed");
    }
}

void check_sides(const CardValidator& validator) {
    const auto& main = validator.interface.main_nodes;
    const auto& secondary = validator.interface.secondary.node;
    std::vector<int> shared;
    std::set_intersection(main.begin(), main.end(), secondary.begin(), secondary.end(), std::back_inserter(shared));
    check_main_nodes(validator, main);
    if (!shared.empty()) validator.reading().report_shared_nodes(validator, node_list(validator.model, shared));
    check_secondary_nodes(validator, secondary, shared);
    check_areas(validator);
    check_elements(validator, "surf_IDs", secondary_surface(validator),
                   "their nodes have no thickness and no stiffness from them");
    check_elements(validator, "surf_IDm", main_surface(validator), "Radioss asks for one under each main segment");
}

}  // namespace type21
