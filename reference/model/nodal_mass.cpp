#include <cmath>
#include <numbers>

#include "reference/model/reading.h"

namespace type21 {

namespace {

const Vec3& corner(const Model& model, const Shell& shell, int i) {
    return model.nodes.position[static_cast<size_t>(shell.node[static_cast<size_t>(i)])];
}

/// Angle of a triangle at its corner i, between the sides to the other two.
double corner_angle(const Model& model, const Shell& shell, int i) {
    const Vec3 a = corner(model, shell, (i + 1) % 3) - corner(model, shell, i);
    const Vec3 b = corner(model, shell, (i + 2) % 3) - corner(model, shell, i);
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// A_e = |d1 x d2| / 2 of the diagonals; for a triangle, whose fourth node is the third, this is its area as well.
double area(const Model& model, const Shell& shell) {
    const Vec3 d1 = corner(model, shell, 2) - corner(model, shell, 0);
    const Vec3 d2 = corner(model, shell, 3) - corner(model, shell, 1);
    return 0.5 * d1.cross(d2).norm();
}

}  // namespace

/// Nodal mass [mass] (formulation 7).
///   quad:     rho t A_e / 4 to each node
///   triangle: rho t A_e (corner angle) / pi
/// plus the added masses. Void material counts with its density.
void sum_nodal_mass(Model& model) {
    std::vector<double>& mass = model.nodal_mass;
    mass.assign(static_cast<size_t>(model.nodes.size()), 0.0);
    for (const Shell& shell : model.shells) {
        const int material = model.parts[static_cast<size_t>(shell.part)].material;
        if (material < 0) continue;
        const double shell_mass =
            model.materials[static_cast<size_t>(material)].density * shell.thickness * area(model, shell);
        for (int i = 0; i < shell.corners(); ++i) {
            const double share = shell.is_triangle() ? corner_angle(model, shell, i) / std::numbers::pi : 0.25;
            mass[static_cast<size_t>(shell.node[static_cast<size_t>(i)])] += shell_mass * share;
        }
    }
    for (const AddedMass& added : model.added_masses) {
        if (added.group < 0) continue;
        const std::vector<int>& nodes = model.groups[static_cast<size_t>(added.group)].nodes;
        const double each = added.shared ? added.mass / static_cast<double>(nodes.size()) : added.mass;
        for (const int node : nodes)
            mass[static_cast<size_t>(node)] += each;
    }
}

}  // namespace type21
