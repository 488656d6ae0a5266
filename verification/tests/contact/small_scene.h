/// @file Scenes built in code for hand calculations: a few free-standing nodes over a small tool, no deck needed.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "reference/model/host_scene.h"

namespace type21::test {

/// A tool of given nodes and segments whose main node is at the origin, and nodes of unit area, mass and stiffness
/// above it.
class SmallScene {
  public:
    SmallScene(const std::vector<Vec3>& tool, const std::vector<std::array<int, 4>>& segments,
               const std::vector<Vec3>& blank) {
        model_.engine.end_time = 1.0;
        model_.engine.first_step = model_.engine.largest_step = 1e-3;
        const int tool_nodes = static_cast<int>(tool.size());
        add_node(900, Vec3::Zero());
        for (const Vec3& x : tool)
            add_node(1000 + model_.nodes.size(), x);
        Surface main;
        for (const auto& s : segments)
            main.segments.push_back({{s[0] + 1, s[1] + 1, s[2] + 1, s[3] + 1}, -1});
        model_.surfaces.push_back(main);
        RigidBody body;
        body.id = 1;
        body.main_node = 0;
        body.mass = 10;
        body.inertia = Mat3::Identity() * 5.0;
        Interface card;
        card.id = 1;
        for (int n = 1; n <= tool_nodes; ++n) {
            body.nodes.push_back(n);
            card.main_nodes.push_back(n);
        }
        model_.rigid_bodies.push_back(body);
        card.secondary_surface = 1;
        card.main_surface = 0;
        card.tool = 0;
        card.stfac.value = 1.0;
        card.stmax.value = 1e30;
        card.tstop.value = 1e30;
        card.depth.value = 2.0;
        card.viss.value = 0.0;
        card.pmax.value = card.gapmax.value = 1e30;
        SecondarySide& side = card.secondary;
        for (const Vec3& x : blank) {
            side.node.push_back(add_node(5000 + model_.nodes.size(), x));
            side.thickness.push_back(0);
            side.contact_thickness.push_back(0);
            side.gap.push_back(0.5);
            side.search_gap.push_back(0.5);
            side.area.push_back(1);
            side.element_stiffness.push_back(1000);
            side.mass.push_back(1);
        }
        card.largest_gap = 0.5;
        card.smallest_gap_raw = 0.5;
        card.shortest_edge = 1;
        model_.surfaces.emplace_back();
        model_.interfaces.push_back(card);
        model_.nodal_mass.assign(static_cast<size_t>(model_.nodes.size()), 1.0);
    }

    Model& model() { return model_; }
    Interface& card() { return model_.interfaces[0]; }
    int blank_node(int i) { return card().secondary.node[static_cast<size_t>(i)]; }

    /// Fixes (or with -1 leaves free) directions of a node.
    void fix(int node, std::array<bool, 6> fixed) {
        NodeGroup group;
        group.nodes = {node};
        model_.groups.push_back(group);
        BoundaryCondition bcs;
        bcs.fixed = fixed;
        bcs.group = static_cast<int>(model_.groups.size()) - 1;
        model_.boundary_conditions.push_back(bcs);
    }

    /// A constant imposed velocity in one direction.
    void drive(int node, int direction, double velocity, ImposedMotion::Kind kind = ImposedMotion::Kind::velocity) {
        Function f;
        f.x = {0.0, 1.0};
        f.y = kind == ImposedMotion::Kind::velocity ? std::vector<double>{1.0, 1.0} : std::vector<double>{0.0, 1.0};
        model_.functions.push_back(f);
        NodeGroup group;
        group.nodes = {node};
        model_.groups.push_back(group);
        ImposedMotion motion;
        motion.kind = kind;
        motion.function = static_cast<int>(model_.functions.size()) - 1;
        motion.direction = direction;
        motion.group = static_cast<int>(model_.groups.size()) - 1;
        motion.scale_y = velocity;
        model_.imposed_motions.push_back(motion);
    }

    /// A constant load on a node: a force (directions 0 to 2) or a moment (3 to 5).
    void load(int node, int direction, double value) {
        model_.functions.push_back({static_cast<Id>(model_.functions.size()) + 1, "", {0.0}, {1.0}});
        NodeGroup group;
        group.nodes = {node};
        model_.groups.push_back(group);
        ConcentratedLoad load;
        load.function = static_cast<int>(model_.functions.size()) - 1;
        load.direction = direction;
        load.group = static_cast<int>(model_.groups.size()) - 1;
        load.scale_y = value;
        model_.loads.push_back(load);
    }

    HostScene scene() const { return plan(std::make_shared<const Model>(model_)); }

  private:
    int add_node(Id id, const Vec3& x) {
        const int index = model_.nodes.size();
        model_.nodes.id.push_back(id);
        model_.nodes.position.push_back(x);
        model_.nodes.line.push_back(0);
        model_.nodes.index[id] = index;
        return index;
    }

    Model model_;
};

/// One quad of side 2 in the plane z = 0, normal +z, centred at the origin.
inline SmallScene over_a_square(const std::vector<Vec3>& blank) {
    return {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}, blank};
}

}  // namespace type21::test
