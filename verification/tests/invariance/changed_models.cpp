#include "changed_models.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "reference/model/model.h"

namespace type21::test {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

template <class Value>
std::vector<Value> reordered(const std::vector<Value>& values, const std::vector<int>& order) {
    std::vector<Value> out(values);
    for (size_t n = 0; n < values.size(); ++n)
        out[at(order[n])] = values[n];
    return out;
}

/// Directions 0..2 are those of a vector, 3..5 those of a rotation, which a mirror turns the other way.
double map_direction(const AxisMap& map, int& direction) {
    const int axis = direction % 3;
    const double sign = map.sign[at(axis)] * (direction < 3 ? 1.0 : map.determinant());
    direction = map.to[at(axis)] + (direction < 3 ? 0 : 3);
    return sign;
}

}  // namespace

Vec3 AxisMap::operator()(const Vec3& v) const {
    Vec3 out;
    for (int d = 0; d < 3; ++d)
        out[to[at(d)]] = sign[at(d)] * v[d];
    return out;
}

double AxisMap::determinant() const {
    const bool even = to[1] == (to[0] + 1) % 3;
    return (even ? 1.0 : -1.0) * sign[0] * sign[1] * sign[2];
}

Model mapped(Model model, const AxisMap& map) {
    for (Vec3& x : model.nodes.position)
        x = map(x);
    for (RigidBody& body : model.rigid_bodies) {
        body.center = map(body.center);
        const Mat3 before = body.inertia;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                body.inertia(map.to[at(i)], map.to[at(j)]) = map.sign[at(i)] * map.sign[at(j)] * before(i, j);
        }
    }
    for (BoundaryCondition& bcs : model.boundary_conditions) {
        const auto before = bcs.fixed;
        for (int d = 0; d < 3; ++d) {
            bcs.fixed[at(map.to[at(d)])] = before[at(d)];
            bcs.fixed[at(map.to[at(d)] + 3)] = before[at(d + 3)];
        }
    }
    for (ImposedMotion& motion : model.imposed_motions)
        motion.scale_y *= map_direction(map, motion.direction);
    for (ConcentratedLoad& load : model.loads)
        load.scale_y *= map_direction(map, load.direction);
    for (InitialVelocity& initial : model.initial_velocities)
        initial.velocity = map(initial.velocity);
    if (map.determinant() < 0) {
        for (Surface& surface : model.surfaces) {
            for (Segment& s : surface.segments) {
                if (s.is_triangle()) {
                    std::swap(s.node[0], s.node[1]);
                } else {
                    std::swap(s.node[1], s.node[3]);
                }
            }
        }
    }
    return model;
}

Model moved(Model model, const Vec3& by) {
    for (Vec3& x : model.nodes.position)
        x += by;
    for (RigidBody& body : model.rigid_bodies)
        body.center += by;
    return model;
}

Model on_a_grid(Model model) {
    const auto round = [](Vec3& x) {
        for (int d = 0; d < 3; ++d)
            x[d] = std::ldexp(std::round(std::ldexp(x[d], 24)), -24);
    };
    for (Vec3& x : model.nodes.position)
        round(x);
    for (RigidBody& body : model.rigid_bodies)
        round(body.center);
    return model;
}

Model with_other_ids(Model model) {
    model.nodes.index.clear();
    for (int n = 0; n < model.nodes.size(); ++n) {
        Id& id = model.nodes.id[at(n)];
        id = 7 * id + 3;
        model.nodes.index[id] = n;
    }
    for (Shell& shell : model.shells)
        shell.id = 7 * shell.id + 3;
    for (Surface& surface : model.surfaces)
        surface.id = 7 * surface.id + 3;
    for (Part& part : model.parts)
        part.id = 7 * part.id + 3;
    return model;
}

Model with_nodes_in_order(const Model& before, const std::vector<int>& order) {
    Model model = before;
    const auto index = [&](int& node) { node = order[at(node)]; };
    model.nodes.position = reordered(before.nodes.position, order);
    model.nodal_mass = reordered(before.nodal_mass, order);
    model.nodal_heat_capacity = reordered(before.nodal_heat_capacity, order);
    for (Shell& shell : model.shells)
        for (int& node : shell.node)
            index(node);
    for (Surface& surface : model.surfaces)
        for (Segment& segment : surface.segments)
            for (int& node : segment.node)
                index(node);
    const auto list = [&](std::vector<int>& nodes) {
        for (int& node : nodes)
            index(node);
        std::sort(nodes.begin(), nodes.end());
    };
    for (NodeGroup& group : model.groups)
        list(group.nodes);
    for (RigidBody& body : model.rigid_bodies) {
        index(body.main_node);
        list(body.nodes);
    }
    for (size_t i = 0; i < model.interfaces.size(); ++i) {
        Interface& interface = model.interfaces[i];
        list(interface.main_nodes);
        SecondarySide& side = interface.secondary;
        list(side.node);
        const SecondarySide& old = before.interfaces[i].secondary;
        for (size_t n = 0; n < old.node.size(); ++n) {
            const auto rank = static_cast<size_t>(
                std::lower_bound(side.node.begin(), side.node.end(), order[at(old.node[n])]) - side.node.begin());
            side.thickness[rank] = old.thickness[n];
            side.contact_thickness[rank] = old.contact_thickness[n];
            side.gap[rank] = old.gap[n];
            side.search_gap[rank] = old.search_gap[n];
            side.area[rank] = old.area[n];
            side.element_stiffness[rank] = old.element_stiffness[n];
            side.mass[rank] = old.mass[n];
        }
    }
    model.histories.clear();
    return model;
}

std::vector<int> shuffled(int count, unsigned seed) {
    std::vector<int> order(at(count));
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 random(seed);
    for (size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
    return order;
}

Model with_main_segments_reversed(Model model) {
    std::set<int> surfaces;
    for (const Interface& interface : model.interfaces)
        surfaces.insert(interface.main_surface);
    for (const int surface : surfaces) {
        auto& segments = model.surfaces[at(surface)].segments;
        std::reverse(segments.begin(), segments.end());
    }
    return model;
}

}  // namespace type21::test
