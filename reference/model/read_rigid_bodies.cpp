#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

/// What the card adds to the masses of the nodes.
struct Added {
    double mass = 0;
    Mat3 inertia = Mat3::Zero();
};

/// Inertia of a point mass about a point at distance r: m (|r|^2 I - r r^T).
Mat3 point_inertia(double mass, const Vec3& r) {
    return mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
}

/// Centre, mass and inertia by the rule of ICoG. The main node's own mass and the added mass stand at the main node.
///   1: centre of main and secondary nodes; the main node moves there
///   2: centre of the secondary nodes alone; the main node moves there with what is added to it
///   3: the main node stays; the secondary nodes count about it
///   4: the main node stays; the secondary nodes do not count
void gather(const Model& model, const Added& added, RigidBody& body) {
    const Vec3 main = model.nodes.position[static_cast<size_t>(body.main_node)];
    const double main_mass = added.mass + model.nodal_mass[static_cast<size_t>(body.main_node)];
    double mass = 0;
    Vec3 moment = Vec3::Zero();  // about the main node, so that a far origin costs no digits
    for (const int node : body.nodes) {
        const double m = model.nodal_mass[static_cast<size_t>(node)];
        mass += m;
        moment += m * (model.nodes.position[static_cast<size_t>(node)] - main);
    }
    body.center = main;
    if (body.icog == 1 && main_mass + mass > 0) body.center += moment / (main_mass + mass);
    if (body.icog == 2 && mass > 0) body.center += moment / mass;
    body.mass = body.icog == 4 ? main_mass : main_mass + mass;
    body.inertia = added.inertia;
    if (body.icog == 4) return;
    if (body.icog == 1) body.inertia += point_inertia(main_mass, main - body.center);
    for (const int node : body.nodes) {
        body.inertia += point_inertia(model.nodal_mass[static_cast<size_t>(node)],
                                      model.nodes.position[static_cast<size_t>(node)] - body.center);
    }
}

/// True when a boundary condition or an imposed motion rules this degree of freedom of the node.
bool ruled(const Model& model, int node, int dof) {
    const auto in_group = [&](int group) {
        if (group < 0) return false;
        const std::vector<int>& nodes = model.groups[static_cast<size_t>(group)].nodes;
        return std::binary_search(nodes.begin(), nodes.end(), node);
    };
    return std::any_of(
               model.boundary_conditions.begin(), model.boundary_conditions.end(),
               [&](const BoundaryCondition& c) { return c.fixed[static_cast<size_t>(dof)] && in_group(c.group); }) ||
           std::any_of(model.imposed_motions.begin(), model.imposed_motions.end(),
                       [&](const ImposedMotion& m) { return m.direction == dof && in_group(m.group); });
}

/// A body that may move needs a mass, one that may turn an inertia; a body that is driven throughout needs neither.
void check_inertia(const Model& model, CardReader& reader, const RigidBody& body) {
    const auto free = [&](int first) {
        for (int dof = first; dof < first + 3; ++dof) {
            if (!ruled(model, body.main_node, dof)) return true;
        }
        return false;
    };
    if (body.mass < 0 || (body.mass == 0 && free(0))) {
        reader.error(1, "Mass", quantity(reader, body.mass, dim::mass), "a body that may move has a positive mass",
                     "Give Mass, or fix or drive the translations of the main node");
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(body.inertia, Eigen::EigenvaluesOnly);
    const double smallest = principal.eigenvalues()[0];
    const double largest = principal.eigenvalues()[2];
    if (smallest <= 1e-12 * largest && free(3)) {
        reader.error(2, "Jxx", quantity(reader, smallest, dim::inertia),
                     "a body that may turn has positive principal moments of inertia; this is its smallest",
                     "Give Jxx to Jxz, or fix or drive the rotations of the main node");
    }
}

Added read_added(CardReader& reader) {
    Added added;
    added.mass = reader.real(1, 41, 60, "Mass", dim::mass);
    constexpr std::array<std::pair<int, int>, 6> places{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
    constexpr std::array<std::string_view, 6> names{"Jxx", "Jyy", "Jzz", "Jxy", "Jyz", "Jxz"};
    for (size_t i = 0; i < places.size(); ++i) {
        const int first = 1 + 20 * static_cast<int>(i % 3);
        const double value = reader.real(i < 3 ? 2 : 3, first, first + 19, names[i], dim::inertia);
        added.inertia(places[i].first, places[i].second) = value;
        added.inertia(places[i].second, places[i].first) = value;
    }
    return added;
}

int choice(CardReader& reader, int first, std::string_view field, int largest, int fallback) {
    const Id value = reader.integer(1, first, first + 9, field);
    if (value == 0) return fallback;
    if (value > 0 && value <= largest) return static_cast<int>(value);
    reader.error(1, field, fmt::format("{}", value), fmt::format("{} is one of 0 to {}", field, largest),
                 "Choose one of these");
    return fallback;
}

/// The main node of a body that names none: a new node at the centre of mass of the body's nodes, with the id behind
/// the highest of the deck.
/// @return its index; -1 and an error when the nodes have no mass
int create_main_node(Model& model, CardReader& reader, const std::vector<int>& nodes) {
    if (nodes.empty()) {
        reader.error(1, "grnod_ID", reader.text(1, 61, 70), "a body without a main node and without nodes is nothing",
                     "Name its nodes");
        return -1;
    }
    double mass = 0;
    Vec3 moment = Vec3::Zero();  // about the first node, so that a far origin costs no digits
    for (const int node : nodes) {
        const double m = model.nodal_mass[static_cast<size_t>(node)];
        mass += m;
        moment += m * (model.nodes.position[static_cast<size_t>(node)] -
                       model.nodes.position[static_cast<size_t>(nodes.front())]);
    }
    if (!(mass > 0) || model.nodes.id.back() == std::numeric_limits<Id>::max()) {
        reader.error(1, "node_ID", "0",
                     "a body without a main node has it at the centre of mass of its nodes; these have no mass",
                     "Name a main node, or give the material of the body a density");
        return -1;
    }
    const int index = model.nodes.size();
    const Id id = model.nodes.id.back() + 1;
    model.nodes.id.push_back(id);
    model.nodes.position.emplace_back(model.nodes.position[static_cast<size_t>(nodes.front())] + moment / mass);
    model.nodes.line.push_back(reader.line_number(1));
    model.nodes.index.emplace(id, index);
    model.nodal_mass.push_back(0);
    if (!model.nodal_heat_capacity.empty()) model.nodal_heat_capacity.push_back(0);
    return index;
}

/// What acts on all nodes of a body without a main node acts on the one that was made: /INIVEL and /GRAV.
void load_created_node(Model& model, const RigidBody& body) {
    const auto whole_body = [&](int group) {
        if (group < 0) return false;
        const std::vector<int>& nodes = model.groups[static_cast<size_t>(group)].nodes;
        return std::includes(nodes.begin(), nodes.end(), body.nodes.begin(), body.nodes.end());
    };
    NodeGroup own;
    own.title = fmt::format("main node of /RBODY/{}", body.id);
    own.nodes = {body.main_node};
    const auto group = static_cast<int>(model.groups.size());
    const auto copy_to_main_node = [&](auto& conditions) {
        const size_t count = conditions.size();
        for (size_t i = 0; i < count; ++i) {
            if (!whole_body(conditions[i].group)) continue;
            auto copy = conditions[i];
            copy.group = group;
            conditions.push_back(copy);
        }
    };
    copy_to_main_node(model.initial_velocities);
    copy_to_main_node(model.gravities);
    model.groups.push_back(std::move(own));
}

/// Index of the main node, -1 after an error.
int read_main_node(Reading& reading, CardReader& reader, int group) {
    const Id id = reader.integer(1, 1, 10, "node_ID");
    if (id == 0) {
        if (group < 0) return -1;  // has had its message
        return create_main_node(reading.model, reader, reading.model.groups[static_cast<size_t>(group)].nodes);
    }
    const auto found = reading.model.nodes.index.find(id);
    if (found != reading.model.nodes.index.end()) return found->second;
    reader.error(1, "node_ID", fmt::format("{}", id), "the main node of a rigid body is a node of the deck",
                 "Add it to /NODE, or correct the id");
    return -1;
}

/// Claims the nodes of a body; a node moves with one body only.
void claim(Reading& reading, CardReader& reader, const RigidBody& body, std::unordered_map<int, Id>& owner) {
    const auto take = [&](int node, std::string_view field) {
        const auto [met, is_new] = owner.emplace(node, body.id);
        if (is_new) return;
        reader.error(1, field, fmt::format("node {}", reading.model.nodes.id[static_cast<size_t>(node)]),
                     fmt::format("a node belongs to one rigid body; this one is in /RBODY/{} too", met->second),
                     "Take it out of one of the node groups");
    };
    if (body.main_node >= 0) take(body.main_node, "node_ID");
    for (const int node : body.nodes)
        take(node, "grnod_ID");
}

}  // namespace

/// /RBODY. Moves main nodes to their centres by ICoG. A body without a main node gets one.
void read_rigid_bodies(Reading& reading) {
    Model& model = reading.model;
    std::unordered_map<int, Id> owner;
    const auto next = [&] { return static_cast<int>(model.rigid_bodies.size()); };
    reading.each(Keyword::rigid_body, reading.rigid_bodies, next, [&](CardReader& reader, Id id) {
        RigidBody body;
        body.id = id;
        body.title = reader.text(0, 1, 100);
        refuse_unless_zero(reader, 1, 11, 20, "sens_ID", "a rigid body on a sensor is");
        const int skew = skew_reference(reading, reader, 1, 21, "skew_ID", reading.skews);
        body.spherical = choice(reader, 31, "Ispher", 2, 2) == 1;
        const int group = reading.reference(reader, 1, 61, 70, "grnod_ID", reading.groups, true);
        body.main_node = read_main_node(reading, reader, group);
        body.icog = choice(reader, 81, "ICoG", 4, 1);
        refuse_unless_zero(reader, 1, 91, 100, "surf_ID", "the inertia of an envelope surface is");
        reader.unused(1, 71, 80, 10);  // Ikrem
        Added added = read_added(reader);
        if (skew >= 0) {
            const Mat3& axes = model.skews[static_cast<size_t>(skew)].axes;
            added.inertia = Mat3(axes * added.inertia * axes.transpose());
        }
        reader.unused(4, 1, 40, 10);  // Ioptoff, Iexpams
        refuse_unless_zero(reader, 4, 41, 50, "Ifail", "failure of a rigid body is");
        warn_of_excess(reader, 5);
        if (group >= 0) body.nodes = model.groups[static_cast<size_t>(group)].nodes;
        std::erase(body.nodes, body.main_node);
        claim(reading, reader, body, owner);
        if (body.main_node >= 0 && group >= 0) {
            gather(model, added, body);
            if (body.spherical) body.inertia = Mat3(Mat3::Identity() * (body.inertia.trace() / 3));
            check_inertia(model, reader, body);
            model.nodes.position[static_cast<size_t>(body.main_node)] = body.center;
            if (reader.integer(1, 1, 10, "node_ID") == 0) load_created_node(model, body);
        }
        model.rigid_bodies.push_back(std::move(body));
    });
}

}  // namespace type21
