#include "optimized/kernel/node_terms.h"

#include <cmath>

namespace type21::optimized {

void add_terms(const NodeContact& n, const NodeHeat* heat, double step, const Vec3& center, TermBlock& block) {
    double* at = block.column();
    const auto put = [&](Term term, double value) { at[static_cast<int>(term) * TermBlock::stride] = value; };
    const auto put_vector = [&](Term first, const V3& v) {
        put(first, v.x);
        put(static_cast<Term>(static_cast<int>(first) + 1), v.y);
        put(static_cast<Term>(static_cast<int>(first) + 2), v.z);
    };
    const auto magnitudes = [](const V3& v) { return V3{std::abs(v.x), std::abs(v.y), std::abs(v.z)}; };
    if (n.status != Status::open) {
        const V3 nu = from(n.normal), velocity = from(n.relative_velocity), friction = from(n.friction);
        const V3 normal = nu * -n.normal_force;
        const V3 total = normal + friction;
        const double vn = dot(velocity, nu);
        const V3 arm = from(n.point) - from(center);
        const V3 on_tool = from(n.force) * -1;
        const double square = dot(arm, arm);
        put_vector(Term::normal_x, normal);
        put_vector(Term::tangential_x, friction);
        put_vector(Term::abs_normal_x, magnitudes(normal));
        put_vector(Term::abs_total_x, magnitudes(total));
        put(Term::signed_normal, -n.normal_force);
        put(Term::norm_total, norm(total));
        put(Term::friction_work, step * dot(velocity, friction));
        put(Term::damping_work, n.damping * vn * vn * step);
        put_vector(Term::force_x, on_tool);
        put_vector(Term::moment_x, cross(arm, on_tool));
        put(Term::stiffness, n.stiffness);
        put(Term::rotation, n.stiffness * square);
        put(Term::step_stiffness, n.step_stiffness);
        put(Term::step_rotation, n.step_stiffness * square);
    } else {
        for (int t = 0; t < static_cast<int>(Term::friction_heat); ++t)
            at[t * TermBlock::stride] = 0;
    }
    put(Term::elastic_energy, n.elastic_energy);
    if (heat != nullptr) {
        put(Term::friction_heat, heat->friction_heat);
        put(Term::heat_to_blank, heat->heat);
    }
    block.next();
}

}  // namespace type21::optimized
