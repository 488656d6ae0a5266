/// @file Nodal sums over shells and segments.
#include "reference/model/secondary_side.h"

#include <algorithm>
#include <limits>

#include "reference/model/card_reading.h"
#include "reference/model/nodal_gaps.h"

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

}  // namespace

std::vector<int> surface_nodes(const Surface& surface) {
    std::vector<int> nodes;
    for (const Segment& segment : surface.segments)
        nodes.insert(nodes.end(), segment.node.begin(), segment.node.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

std::vector<double> element_stiffness(const Model& model, const std::vector<int>& nodes) {
    std::vector<double> sum(model.nodes.id.size(), 0.0);
    std::vector<int> shells(model.nodes.id.size(), 0);
    for (const Shell& shell : model.shells) {
        const int material = shell.part < 0 ? -1 : model.parts[at(shell.part)].material;
        if (material < 0) continue;
        for (int corner = 0; corner < shell.corners(); ++corner) {
            sum[at(shell.node[at(corner)])] += model.materials[at(material)].young * shell.thickness;
            ++shells[at(shell.node[at(corner)])];
        }
    }
    std::vector<double> mean;
    mean.reserve(nodes.size());
    for (const int node : nodes)
        mean.push_back(shells[at(node)] == 0 ? 0.0 : sum[at(node)] / shells[at(node)]);
    return mean;
}

std::vector<double> nodal_area(const Model& model, const Surface& surface, const std::vector<int>& nodes) {
    std::vector<double> area(model.nodes.id.size(), 0.0);
    const auto& x = model.nodes.position;
    for (size_t rank = 0; rank < surface.segments.size(); ++rank) {
        if (surface.is_repeated(static_cast<int>(rank))) continue;
        const Segment& segment = surface.segments[rank];
        const auto& n = segment.node;
        // A triangle repeats its third node, so that the diagonals are two of its sides.
        const double whole = 0.5 * (x[at(n[2])] - x[at(n[0])]).cross(x[at(n[3])] - x[at(n[1])]).norm();
        for (int corner = 0; corner < segment.corners(); ++corner)
            area[at(n[at(corner)])] += whole / segment.corners();
    }
    std::vector<double> of_nodes;
    of_nodes.reserve(nodes.size());
    for (const int node : nodes)
        of_nodes.push_back(area[at(node)]);
    return of_nodes;
}

double shortest_edge(const Model& model, const Surface& surface) {
    double shortest = std::numeric_limits<double>::infinity();
    const auto& x = model.nodes.position;
    for (const Segment& segment : surface.segments)
        for (size_t corner = 0; corner < 4; ++corner) {
            const int a = segment.node[corner];
            const int b = segment.node[(corner + 1) % 4];
            if (a != b) shortest = std::min(shortest, (x[at(b)] - x[at(a)]).norm());
        }
    return shortest;
}

/// @manual field surf_IDs
void build_secondary_side(const CardValidator& validator) {
    Interface& it = validator.interface;
    const Model& model = validator.model;
    const Surface& surface = model.surfaces[at(it.secondary_surface)];
    SecondarySide& side = it.secondary;
    side.node = surface_nodes(surface);
    side.thickness = nodal_thickness(model, side.node);
    side.contact_thickness = validator.reading().contact_thickness(model, surface, side.node);
    side.area = nodal_area(model, surface, side.node);
    side.element_stiffness = element_stiffness(model, side.node);
    for (const int node : side.node)
        side.mass.push_back(at(node) < model.nodal_mass.size() ? model.nodal_mass[at(node)] : 0.0);
    it.shortest_edge = shortest_edge(model, surface);
}

}  // namespace type21
