#include "verification/stability/sliding.h"

#include <algorithm>
#include <cmath>

#include "verification/stability/facet_contact.h"
#include "verification/stability/long_run_scene.h"
#include "verification/support/prescribed_motion.h"

namespace type21::stability {
namespace {

constexpr double path_length = 10.0;  ///< arc of the path [mm]
constexpr double path_start = -5.1;   ///< [mm]
constexpr double drift = 0.37;        ///< y per arc: the path crosses edges and diagonals at no special angle
/// The first part of the path does not count: friction has to slip and to forget its start, exp(-way k / (mu F_n)) <
/// 1e-14 [mm].
constexpr double run_in = 2.0;

Vec3 on_path(Shape shape, double way) {
    const double s = path_start + way;
    return over(shape, s, 0.13 + drift * s, gap - path_depth);
}

/// Largest change from one step to the next.
class JumpOf {
  public:
    void see(const Vec3& force, double way) {
        if (way > run_in) largest_ = std::max(largest_, (force - last_).norm());
        last_ = force;
    }
    double largest() const { return largest_; }

  private:
    Vec3 last_ = Vec3::Zero();
    double largest_ = 0;
};

}  // namespace

double Jumps::residual() const {
    return std::max(0.0, 2 * largest[path_steps - 1] - largest[path_steps - 2]);
}

SlidingRow slide_over(const MakeContact& make_contact, Shape shape, Mesh mesh) {
    SlidingRow row;
    row.shape = shape;
    row.mesh = mesh;
    const SurfaceMesh tool = make_tool(shape, mesh);
    const FacetContact facets(tool);
    const HostScene scene = long_run_scene(tool, {on_path(shape, 0)}).fric(path_friction).scene();
    for (size_t i = 0; i < path_steps; ++i) {
        const double h = first_step / std::pow(2.0, static_cast<double>(i));
        const long cycles = std::lround(path_length / h);
        PrescribedNode node(scene, make_contact);
        JumpOf normal, friction, facet_normal, facet_friction;
        double sum = 0;
        Vec3 before = on_path(shape, -h);
        for (long n = 0; n <= cycles; ++n) {
            const double way = static_cast<double>(n) * h;
            const Vec3 x = on_path(shape, way);
            const Vec3 travel = x - before;
            const NodeContact contact = node.to(x, travel, 1.0);
            const FacetForce facet = facets.at(x, travel, path_friction);
            if (contact.status == Status::open) ++row.open;
            normal.see(contact.normal_force * contact.normal, way);
            friction.see(contact.friction, way);
            facet_normal.see(facet.normal, way);
            facet_friction.see(facet.friction, way);
            sum += std::abs(contact.normal_force);
            before = x;
        }
        row.mean_force = sum / static_cast<double>(cycles + 1);
        row.normal.largest[i] = normal.largest();
        row.friction.largest[i] = friction.largest();
        row.facet_normal.largest[i] = facet_normal.largest();
        row.facet_friction.largest[i] = facet_friction.largest();
    }
    return row;
}

std::vector<SlidingRow> slide_over_all(const MakeContact& make_contact) {
    std::vector<SlidingRow> rows;
    for (const Shape shape : {Shape::flat, Shape::convex, Shape::concave}) {
        for (const Mesh mesh : {Mesh::quad, Mesh::triangle, Mesh::distorted, Mesh::warped})
            rows.push_back(slide_over(make_contact, shape, mesh));
    }
    return rows;
}

}  // namespace type21::stability
