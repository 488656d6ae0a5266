/// @file Nodes, shells, parts, surfaces and groups of the model.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "node_index.h"
#include "vector.h"

namespace type21 {

/// Nodes, sorted by id so that an index order is an id order.
struct Nodes {
    std::vector<Id> id;
    std::vector<Vec3> position;  ///< at time 0 [length]
    std::vector<int> line;       ///< deck line of each
    NodeIndex index;

    int size() const { return static_cast<int>(id.size()); }
};

enum class MaterialLaw { none = 0, elastic = 1, johnson_cook = 2 };  ///< Radioss law numbers 0 (void), 1, 2

/// /HEAT/MAT: what makes a material thermal.
struct HeatMaterial {
    double initial_temperature = 0;  ///< T0 [temperature]
    double heat_capacity = 0;        ///< rho Cp [energy/(volume temperature)]
    double conductivity_a = 0;       ///< A_S [power/(length temperature)]
    double conductivity_b = 0;       ///< B_S [power/(length temperature^2)]
};

struct Material {
    Id id = 0;
    std::string title;
    MaterialLaw law = MaterialLaw::none;
    double density = 0;               ///< [mass/length^3]
    double young = 0;                 ///< [pressure]
    double poisson = 0;               ///< [-]
    std::array<double, 5> plastic{};  ///< Johnson-Cook a, b, n, epsmax, sigmax
    std::optional<HeatMaterial> heat;
};

enum class PropertyKind { none = 0, shell = 1 };

struct Property {
    Id id = 0;
    std::string title;
    PropertyKind kind = PropertyKind::shell;
    double thickness = 0;  ///< [length]
    int integration_points = 0;
    int thickness_change = 0;  ///< Ithick
};

struct Part {
    Id id = 0;
    std::string title;
    int property = -1;             ///< index into Model::properties
    int material = -1;             ///< index into ContactModel::materials
    double contact_thickness = 0;  ///< Thick of /PART [length], 0: none
};

/// A shell of four nodes, or of three with node[3] == node[2].
struct Shell {
    Id id = 0;
    std::array<int, 4> node{};
    int part = -1;         ///< index into ContactModel::parts
    double thickness = 0;  ///< at time 0 [length]

    bool is_triangle() const { return node[2] == node[3]; }
    int corners() const { return is_triangle() ? 3 : 4; }
};

/// A piece of a surface. A triangle repeats its third node. The order gives the outward side.
struct Segment {
    std::array<int, 4> node{};
    int shell = -1;  ///< index into ContactModel::shells of the element it lies on, -1 if none

    bool is_triangle() const { return node[2] == node[3]; }
    int corners() const { return is_triangle() ? 3 : 4; }
};

struct Surface {
    Id id = 0;
    std::string title;
    std::vector<Segment> segments;  ///< in the order of the deck; their rank + 1 is the segment number
    /// Ranks, ascending, of the segments whose nodes an earlier segment has, in whatever order: they add neither to
    /// areas nor to normals. Empty with D41.  Formulation 1, step 4; Formulation 7, step 3.
    std::vector<int> repeated;

    /// Whether the segment of this rank is one of `repeated`.
    bool is_repeated(int rank) const {
        return !repeated.empty() && std::binary_search(repeated.begin(), repeated.end(), rank);
    }
};

struct NodeGroup {
    Id id = 0;
    std::string title;
    std::vector<int> nodes;  ///< ascending, each once
};

}  // namespace type21
