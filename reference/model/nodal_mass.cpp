#include <algorithm>
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

/// Gives each node its share of what its shells hold:
///   quad:     q t A_e / 4 to each node
///   triangle: q t A_e (corner angle) / pi
/// @param per_volume  q of a material: its density, or its heat capacity of a volume
template <class PerVolume>
void lump(const Model& model, PerVolume&& per_volume, std::vector<double>& sum) {
    sum.assign(static_cast<size_t>(model.nodes.size()), 0.0);
    for (const Shell& shell : model.shells) {
        const int material = model.parts[static_cast<size_t>(shell.part)].material;
        if (material < 0) continue;
        const double held =
            per_volume(model.materials[static_cast<size_t>(material)]) * shell.thickness * area(model, shell);
        for (int i = 0; i < shell.corners(); ++i) {
            const double share = shell.is_triangle() ? corner_angle(model, shell, i) / std::numbers::pi : 0.25;
            sum[static_cast<size_t>(shell.node[static_cast<size_t>(i)])] += held * share;
        }
    }
}

}  // namespace

/// Nodal mass [mass] (Formulation 7, step 6): lumped density plus the added masses. Void material counts with its
/// density.
void sum_nodal_mass(Model& model) {
    std::vector<double>& mass = model.nodal_mass;
    lump(
        model, [](const Material& material) { return material.density; }, mass);
    for (const AddedMass& added : model.added_masses) {
        if (added.group < 0) continue;
        const std::vector<int>& nodes = model.groups[static_cast<size_t>(added.group)].nodes;
        const double each = added.shared ? added.mass / static_cast<double>(nodes.size()) : added.mass;
        for (const int node : nodes)
            mass[static_cast<size_t>(node)] += each;
    }
}

/// Nodal heat capacity [energy/temperature] (Formulation 9, step 12): lumped rho Cp with the shares of the mass, void
/// material with /HEAT/MAT too. Empty when no material is thermal.
void sum_nodal_heat_capacity(Model& model) {
    model.nodal_heat_capacity.clear();
    if (std::none_of(model.materials.begin(), model.materials.end(),
                     [](const Material& m) { return m.heat.has_value(); }))
        return;
    lump(
        model, [](const Material& material) { return material.heat ? material.heat->heat_capacity : 0.0; },
        model.nodal_heat_capacity);
}

}  // namespace type21
