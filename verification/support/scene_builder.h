/// @file Scenes built in code, without a deck: a rigid tool, the nodes of a blank over it, one interface, and what
/// drives the nodes. For tests, long runs and measurements.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "reference/model/host_scene.h"

namespace type21 {

/// Nodes and segments of a tool or of a sheet.
struct SurfaceMesh {
    std::vector<Vec3> node;                   ///< [length]
    std::vector<std::array<int, 4>> segment;  ///< indices into node, from 0; a triangle repeats its third node
};

/// The quads of a grid of (columns + 1) x (rows + 1) nodes that are numbered row by row. Outward is (direction of a
/// row) x (direction of a column).
std::vector<std::array<int, 4>> grid_segments(int columns, int rows);

/// A grid of columns x rows quads.
/// @param place  column and row of a node, from 0 -> its position [length]
SurfaceMesh grid(int columns, int rows, const std::function<Vec3(int column, int row)>& place);

/// Each quad cut along the diagonal from its first to its third node.
std::vector<std::array<int, 4>> split_quads(const std::vector<std::array<int, 4>>& quads);

/// What every node of a blank has.
struct BlankNode {
    double gap = 0.5;                 ///< g [length]
    double area = 1;                  ///< A [length^2]
    double element_stiffness = 1000;  ///< S, mean of E t of the elements at the node [force/length]
    double mass = 1;                  ///< m [mass]
    double thickness = 0;             ///< t0 of the elements at the node, 0: none [length]
};

/// Builds a Model with one interface, step by step. Every function returns the builder, so that calls can be chained:
///
///     SceneBuilder().main_node({0, 0, 0}).tool(mesh).blank({{0.2, 0.1, 0.3}}).scene()
///
/// Nodes get their indices in the order of the calls. Ids are the first id of a call plus the index, so first ids must
/// ascend. The numbers are in any consistent system of units.
///
/// Unless it is changed, the card asks for a penalty force only: Stfac 1 with Istf 0 (k = S), no damping, no friction,
/// DEPTH 2 and no limit. The body has a mass of 10 and an inertia of 5 about every axis.
class SceneBuilder {
  public:
    SceneBuilder();

    // The parts. Nothing of them is checked.

    /// The main node of the tool. A contact that is stepped by hand does without; a march needs it.
    SceneBuilder& main_node(const Vec3& x, Id id = 900);
    /// Nodes and segments of the tool: the main surface.
    SceneBuilder& tool(const SurfaceMesh& mesh, Id first_id = 1000);
    /// Secondary nodes, at first without segments.
    SceneBuilder& blank(const std::vector<Vec3>& nodes, const BlankNode& each = {}, Id first_id = 100000);
    /// Segments of the blank, without elements. @param segments  indices into the blank's nodes
    SceneBuilder& blank_segments(const std::vector<std::array<int, 4>>& segments);
    /// Shells of one part on the blank, each with a segment. @param shells  indices into the blank's nodes
    SceneBuilder& blank_shells(const std::vector<std::array<int, 4>>& shells, double thickness,
                               const Material& material);
    SceneBuilder& units(const UnitSystem& system);

    // The card.

    Interface& card() { return model_.interfaces[0]; }
    SceneBuilder& card(const std::function<void(Interface& card)>& change);
    SceneBuilder& depth(double length) {
        return card([=](Interface& card) { card.depth.value = length; });
    }
    SceneBuilder& viss(double value) {
        return card([=](Interface& card) { card.viss.value = value; });
    }
    SceneBuilder& fric(double value) {
        return card([=](Interface& card) { card.fric.value = value; });
    }

    // What drives the nodes. `node` is an index; directions 0 to 2 are translations, 3 to 5 rotations.

    SceneBuilder& fix(int node, const std::array<bool, 6>& fixed);
    SceneBuilder& hold(int node) { return fix(node, {true, true, true, true, true, true}); }
    /// Imposed motion: a constant velocity, or a displacement of value x time.
    SceneBuilder& drive(int node, int direction, double value,
                        ImposedMotion::Kind kind = ImposedMotion::Kind::velocity);
    /// A force or moment that rises to its value within `ramp` [time] and stays there; 0: from the beginning.
    SceneBuilder& load(int node, int direction, double value, double ramp = 0);
    /// A constant time step. The run ends with the first cycle at or beyond `end` [time].
    SceneBuilder& time_steps(double step, double end);

    // What was built.

    Model& model() { return model_; }
    const Model& model() const { return model_; }
    /// Index of the main node, -1 without.
    int main_node() const { return model_.rigid_bodies[0].main_node; }
    /// Index of the blank's node i.
    int blank_node(int i) const { return model_.interfaces[0].secondary.node[static_cast<size_t>(i)]; }
    /// The scene of what is built so far, with the effects that its card asks for.
    HostScene scene() const;

  private:
    int add_node(Id id, const Vec3& x, double mass);
    void add_segments(int surface, const std::vector<std::array<int, 4>>& segments, const std::vector<int>& nodes);
    int group_of(int node);
    int function_of(std::vector<double> x, std::vector<double> y);

    Model model_;
};

}  // namespace type21
