#include "verification/decisions/deck_fuzz/deck_input.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include "reference/host/conditions.h"
#include "reference/model/field_table.h"
#include "reference/model/host_scene.h"
#include "reference/model/model.h"
#include "reference/model/resolve.h"

namespace type21::fuzz {
namespace {

void promise(bool kept, const char* what) {
    if (!kept) throw std::logic_error(what);
}

bool within(int index, size_t size) {
    return index >= 0 && static_cast<size_t>(index) < size;
}

/// What every later step relies on without checking again.
void check_promises(const Model& model) {
    const auto nodes = static_cast<size_t>(model.nodes.size());
    promise(model.nodes.position.size() == nodes && model.nodal_mass.size() == nodes, "sizes of the nodes");
    for (const Vec3& x : model.nodes.position)
        promise(x.allFinite(), "a node's position is not finite");
    for (const double mass : model.nodal_mass)
        promise(std::isfinite(mass) && mass >= 0, "a nodal mass is not finite and >= 0");
    for (const Shell& shell : model.shells) {
        promise(within(shell.part, model.parts.size()), "part of a shell");
        promise(std::isfinite(shell.thickness), "thickness of a shell");
        for (const int node : shell.node)
            promise(within(node, nodes), "node of a shell");
    }
    for (const Part& part : model.parts) {
        promise(within(part.property, model.properties.size()), "property of a part");
        promise(within(part.material, model.materials.size()), "material of a part");
    }
    for (const Surface& surface : model.surfaces) {
        for (const Segment& segment : surface.segments) {
            for (const int node : segment.node)
                promise(within(node, nodes), "node of a segment");
            promise(segment.shell < 0 || within(segment.shell, model.shells.size()), "shell of a segment");
        }
    }
    for (const NodeGroup& group : model.groups) {
        for (const int node : group.nodes)
            promise(within(node, nodes), "node of a group");
    }
    for (const Function& function : model.functions) {
        promise(!function.x.empty() && function.x.size() == function.y.size(), "points of a function");
        for (size_t i = 1; i < function.x.size(); ++i)
            promise(function.x[i] > function.x[i - 1], "abscissas of a function do not ascend");
    }
    for (const RigidBody& body : model.rigid_bodies) {
        promise(within(body.main_node, nodes), "main node of a rigid body");
        promise(body.center.allFinite() && std::isfinite(body.mass) && body.inertia.allFinite(), "mass of a body");
    }
    for (const Interface& interface : model.interfaces) {
        promise(within(interface.tool, model.rigid_bodies.size()), "tool of an interface");
        promise(within(interface.main_surface, model.surfaces.size()), "main surface");
        promise(within(interface.secondary_surface, model.surfaces.size()), "secondary surface");
        const SecondarySide& side = interface.secondary;
        for (size_t i = 0; i < side.node.size(); ++i) {
            promise(within(side.node[i], nodes), "secondary node");
            promise(std::isfinite(side.gap[i]) && std::isfinite(side.area[i]), "gap or area of a secondary node");
            promise(std::isfinite(side.element_stiffness[i]) && std::isfinite(side.mass[i]), "stiffness or mass");
        }
    }
    promise(std::isfinite(model.engine.end_time), "end time");
}

}  // namespace

std::vector<MemoryFile> deck_files(std::string_view text) {
    std::vector<MemoryFile> files{{"fuzz_0000.rad", ""}};
    while (!text.empty()) {
        const size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        const std::string_view line = text.substr(0, end);
        if (line.starts_with(file_mark)) {
            std::string_view path = line.substr(file_mark.size());
            path = path.substr(0, path.find_first_of("\r\n"));
            files.push_back({std::string(path), ""});
        } else {
            files.back().bytes += line;
        }
        text.remove_prefix(end);
    }
    return files;
}

Reading read_and_resolve(std::string_view text, const AsBuilt& departures) {
    Problems problems;
    Reading reading;
    const Deck deck = read_deck(deck_files(text), problems);
    if (!deck.starter.empty() || !problems.has_errors()) {
        auto model = std::make_shared<const Model>(resolve(deck, departures, problems));
        if (!problems.has_errors()) {
            check_promises(*model);
            const HostScene scene = plan(model);
            check_runnable(scene, problems);
            for (const Interface& interface : model->interfaces) {
                for (const FieldRow& row : field_table(interface, model->units))
                    reading.length += row.value.size();
            }
        }
    }
    for (const Problem& problem : problems.list())
        reading.length += to_text(problem).size();
    reading.accepted = !problems.has_errors();
    return reading;
}

}  // namespace type21::fuzz
