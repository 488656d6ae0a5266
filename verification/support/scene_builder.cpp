#include "verification/support/scene_builder.h"

#include <memory>
#include <numeric>
#include <utility>

namespace type21 {

std::vector<std::array<int, 4>> grid_segments(int columns, int rows) {
    std::vector<std::array<int, 4>> segments;
    segments.reserve(static_cast<size_t>(columns) * static_cast<size_t>(rows));
    const int next_row = columns + 1;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int first = row * next_row + column;
            segments.push_back({first, first + 1, first + next_row + 1, first + next_row});
        }
    return segments;
}

SurfaceMesh grid(int columns, int rows, const std::function<Vec3(int column, int row)>& place) {
    SurfaceMesh mesh;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            mesh.node.push_back(place(column, row));
    mesh.segment = grid_segments(columns, rows);
    return mesh;
}

std::vector<std::array<int, 4>> split_quads(const std::vector<std::array<int, 4>>& quads) {
    std::vector<std::array<int, 4>> triangles;
    for (const auto& q : quads) {
        triangles.push_back({q[0], q[1], q[2], q[2]});
        triangles.push_back({q[0], q[2], q[3], q[3]});
    }
    return triangles;
}

SceneBuilder::SceneBuilder() {
    RigidBody body;
    body.id = 1;
    body.mass = 10;
    body.inertia = Mat3::Identity() * 5.0;
    model_.rigid_bodies.push_back(body);
    Interface card;
    card.id = 1;
    card.tool = 0;
    card.stfac.value = 1;
    card.depth.value = 2;
    card.viss.value = 0;
    card.stmax.value = card.tstop.value = card.pmax.value = card.gapmax.value = card.pskid.value = no_limit;
    model_.interfaces.push_back(card);
}

SceneBuilder& SceneBuilder::main_node(const Vec3& x, Id id) {
    RigidBody& body = model_.rigid_bodies[0];
    body.main_node = add_node(id, x, 1);
    body.center = x;
    return *this;
}

SceneBuilder& SceneBuilder::tool(const SurfaceMesh& mesh, Id first_id) {
    std::vector<int> nodes;
    nodes.reserve(mesh.node.size());
    for (const Vec3& x : mesh.node)
        nodes.push_back(add_node(first_id + model_.nodes.size(), x, 1));
    card().main_surface = static_cast<int>(model_.surfaces.size());
    model_.surfaces.emplace_back();
    add_segments(card().main_surface, mesh.segment, nodes);
    card().main_nodes = model_.rigid_bodies[0].nodes = std::move(nodes);
    return *this;
}

SceneBuilder& SceneBuilder::blank(const std::vector<Vec3>& nodes, const BlankNode& each, Id first_id) {
    SecondarySide& side = card().secondary;
    for (const Vec3& x : nodes) {
        side.node.push_back(add_node(first_id + model_.nodes.size(), x, each.mass));
        side.thickness.push_back(each.thickness);
        side.contact_thickness.push_back(0);
        side.gap.push_back(each.gap);
        side.search_gap.push_back(each.gap);
        side.area.push_back(each.area);
        side.element_stiffness.push_back(each.element_stiffness);
        side.mass.push_back(each.mass);
    }
    card().secondary_surface = static_cast<int>(model_.surfaces.size());
    model_.surfaces.emplace_back();
    card().largest_gap = card().smallest_gap_raw = each.gap;
    card().shortest_edge = 1;
    return *this;
}

SceneBuilder& SceneBuilder::blank_segments(const std::vector<std::array<int, 4>>& segments) {
    add_segments(card().secondary_surface, segments, card().secondary.node);
    return *this;
}

SceneBuilder& SceneBuilder::blank_shells(const std::vector<std::array<int, 4>>& shells, double thickness,
                                         const Material& material) {
    Part part;
    part.material = static_cast<int>(model_.materials.size());
    part.property = static_cast<int>(model_.properties.size());
    model_.materials.push_back(material);
    model_.properties.emplace_back();
    auto& segments = model_.surfaces[static_cast<size_t>(card().secondary_surface)].segments;
    const size_t first = segments.size();
    blank_segments(shells);
    for (size_t i = first; i < segments.size(); ++i) {
        Shell shell;
        shell.id = static_cast<Id>(model_.shells.size()) + 1;
        shell.node = segments[i].node;
        shell.part = static_cast<int>(model_.parts.size());
        shell.thickness = thickness;
        segments[i].shell = static_cast<int>(model_.shells.size());
        model_.shells.push_back(shell);
    }
    model_.parts.push_back(part);
    return *this;
}

SceneBuilder& SceneBuilder::units(const UnitSystem& system) {
    model_.units = model_.input_units = system;
    return *this;
}

SceneBuilder& SceneBuilder::card(const std::function<void(Interface& card)>& change) {
    change(card());
    return *this;
}

SceneBuilder& SceneBuilder::fix(int node, const std::array<bool, 6>& fixed) {
    BoundaryCondition condition;
    condition.fixed = fixed;
    condition.group = group_of(node);
    model_.boundary_conditions.push_back(condition);
    return *this;
}

SceneBuilder& SceneBuilder::drive(int node, int direction, double value, ImposedMotion::Kind kind) {
    ImposedMotion motion;
    motion.kind = kind;
    motion.function =
        kind == ImposedMotion::Kind::velocity ? function_of({0.0}, {1.0}) : function_of({0.0, 1.0}, {0.0, 1.0});
    motion.direction = direction;
    motion.group = group_of(node);
    motion.scale_y = value;
    model_.imposed_motions.push_back(motion);
    return *this;
}

SceneBuilder& SceneBuilder::load(int node, int direction, double value, double ramp) {
    ConcentratedLoad load;
    load.function = ramp > 0 ? function_of({0.0, ramp, 2.0 * ramp}, {0.0, 1.0, 1.0}) : function_of({0.0}, {1.0});
    load.direction = direction;
    load.group = group_of(node);
    load.scale_y = value;
    model_.loads.push_back(load);
    return *this;
}

SceneBuilder& SceneBuilder::time_steps(double step, double end) {
    model_.engine.first_step = model_.engine.largest_step = step;
    model_.engine.end_time = end;
    return *this;
}

HostScene SceneBuilder::scene() const {
    return plan(std::make_shared<const Model>(model_));
}

int SceneBuilder::add_node(Id id, const Vec3& x, double mass) {
    const int index = model_.nodes.size();
    model_.nodes.id.push_back(id);
    model_.nodes.position.push_back(x);
    model_.nodes.line.push_back(0);
    model_.nodes.index[id] = index;
    model_.nodal_mass.push_back(mass);
    return index;
}

void SceneBuilder::add_segments(int surface, const std::vector<std::array<int, 4>>& segments,
                                const std::vector<int>& nodes) {
    for (const auto& corners : segments) {
        Segment segment;
        for (size_t j = 0; j < 4; ++j)
            segment.node[j] = nodes[static_cast<size_t>(corners[j])];
        model_.surfaces[static_cast<size_t>(surface)].segments.push_back(segment);
    }
}

int SceneBuilder::group_of(int node) {
    NodeGroup group;
    group.nodes = {node};
    model_.groups.push_back(group);
    return static_cast<int>(model_.groups.size()) - 1;
}

int SceneBuilder::function_of(std::vector<double> x, std::vector<double> y) {
    model_.functions.push_back({static_cast<Id>(model_.functions.size()) + 1, "", std::move(x), std::move(y)});
    return static_cast<int>(model_.functions.size()) - 1;
}

}  // namespace type21
