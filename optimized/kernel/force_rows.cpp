#include "optimized/kernel/force_rows.h"

#include <cmath>

namespace type21::optimized {

namespace {

constexpr bool has(unsigned effects, unsigned one) {
    return (effects & one) != 0;
}

template <class L>
TYPE21_INLINE void only(const IntegerLanes<L>& mask, L& v) {
    v = (L)((IntegerLanes<L>)v & mask);
}

/// All ones where v < 0.
template <class L>
TYPE21_INLINE void negative(const L& v, IntegerLanes<L>& mask) {
    mask = (IntegerLanes<L>)v >> 63;
}

/// @manual eq 5, 6, 12; field VISs, Fric, Pmax, ITlim; comment 5, 14
template <unsigned Effects, int W>
TYPE21_INLINE void act(const ForceCycle& c, const Search::Batch& at, ForceRows& f, int j, TermBlock& block) {
    using L = Lanes<W>;
    using I = IntegerLanes<L>;
    using V = VectorLanes<L>;
    L gap, k, offset, lift;
    I contact, first;
    load(f.contact + j, contact);
    load(f.first + j, first);
    load(f.gap + j, gap);
    load(f.stiffness + j, k);
    load(f.offset + j, offset);
    const int i = f.at + j;
    load(at.lift + i, lift);
    const L zero = (L)(contact ^ contact);

    // Formulation 5, steps 1 to 4.
    V n, x, nu, arm, point, y;
    load(at.n[0] + i, at.n[1] + i, at.n[2] + i, n);
    load(at.x[0] + i, at.x[1] + i, at.x[2] + i, x);
    load(at.y[0] + i, at.y[1] + i, at.y[2] + i, y);
    L square, length, largest, other;
    dot_of(n, n, square);
    root_of(square, length);
    scale(n, 1.0 / length);
    turn<false>(c.rotation, n, nu);
    turn<false>(c.rotation, x, arm);
    point.x = c.center[0] + arm.x;
    point.y = c.center[1] + arm.y;
    point.z = c.center[2] + arm.z;
    const L distance = lift * length;
    magnitude_of(y.x, largest);
    magnitude_of(y.y, other);
    most_of(other, largest);
    magnitude_of(y.z, other);
    most_of(other, largest);
    // The distance to the next double above: the next pattern of bits.
    const L ulp = (L)((I)largest + 1) - largest;
    const L depth = gap - distance;
    L p_g = depth > 16.0 * ulp ? depth : zero;
    only(contact, p_g);
    I in_contact;
    negative(zero - p_g, in_contact);

    // Formulation 6, steps 2 to 4.
    choose(first, p_g, offset);
    L toward = p_g;
    if (c.inacti6) {
        magnitude_of(gap - p_g, other);
        toward = p_g + 0.05 * other;
    }
    L moved = 0.95 * offset + 0.05 * toward;
    least_of(offset, moved);
    offset = moved;
    only(in_contact, offset);
    L p = p_g - offset;
    most_of(zero, p);
    I deeper;
    negative(zero - p, deeper);
    L acting = k;
    only(deeper | first, acting);

    // Formulation 7, steps 2 to 7.
    V v;
    load(f.velocity[0] + j, f.velocity[1] + j, f.velocity[2] + j, v);
    v.x -= c.speed[0] + (c.turning[1] * arm.z - c.turning[2] * arm.y);
    v.y -= c.speed[1] + (c.turning[2] * arm.x - c.turning[0] * arm.z);
    v.z -= c.speed[2] + (c.turning[0] * arm.y - c.turning[1] * arm.x);
    L elastic = acting * p, energy = 0.5 * acting * p * p, pmax_force;
    if constexpr (has(Effects, effect::pmax)) {
        L growth;
        load(f.growth + j, growth);
        load(f.pmax_force + j, pmax_force);
        I yields;
        negative(pmax_force - acting * growth, yields);
        L beyond = p - growth, flat = acting * p;
        most_of(zero, beyond);
        least_of(pmax_force, flat);
        const L force = acting * beyond + flat;
        const L straight = force / acting;
        L plateau = p - straight;
        most_of(zero, plateau);
        choose(yields, plateau * pmax_force + 0.5 * straight * force, energy);
        choose(yields, force, elastic);
    }
    L vn, damping = zero;
    dot_of(v, nu, vn);
    if constexpr (has(Effects, effect::damping)) {
        L mass, root;
        load(f.mass + j, mass);
        root_of(2.0 * acting * mass, root);
        damping = c.viss * root;
    }
    const L normal_force = elastic - damping * vn;
    L step_stiffness = acting + damping * c.per_step;
    only(in_contact, step_stiffness);

    // Formulation 8, steps 1 to 10.
    V friction{zero, zero, zero};
    if constexpr (has(Effects, effect::friction)) {
        V old;
        L increment, along, size, limit;
        load(f.friction[0] + j, f.friction[1] + j, f.friction[2] + j, old);
        load(f.increment + j, increment);
        only(deeper | first, increment);
        increment *= c.filtered_step;
        V trial;
        trial.x = old.x + v.x * increment;
        trial.y = old.y + v.y * increment;
        trial.z = old.z + v.z * increment;
        dot_of(trial, nu, along);
        trial.x -= nu.x * along;
        trial.y -= nu.y * along;
        trial.z -= nu.z * along;
        dot_of(trial, trial, square);
        root_of(square, size);
        magnitude_of(normal_force, limit);
        if constexpr (has(Effects, effect::law)) {
            V across;
            L mu;
            across.x = v.x - nu.x * vn;
            across.y = v.y - nu.y * vn;
            across.z = v.z - nu.z * vn;
            dot_of(across, across, square);
            root_of(square, mu);
            store(mu, f.sliding + j);
            store(normal_force, f.normal_force + j);
            store(in_contact, f.in_contact + j);
            coefficients_in_rows(c, at, f, j, W);
            load(f.mu + j, mu);
            limit *= mu;
        } else {
            limit *= c.mu;
        }
        if constexpr (has(Effects, effect::pmax)) {
            if (c.limited) least_of(pmax_force / std::sqrt(3.0), limit);
        }
        I slides;
        negative(limit - size, slides);
        L share = zero + 1.0;
        choose(slides, limit / size, share);
        friction.x = trial.x * share;
        friction.y = trial.y * share;
        friction.z = trial.z * share;
        only(in_contact, friction.x);
        only(in_contact, friction.y);
        only(in_contact, friction.z);
        store(friction, f.friction[0] + j, f.friction[1] + j, f.friction[2] + j);
        store(slides, f.slides + j);
    }
    V normal, force;
    normal.x = nu.x * -normal_force;
    normal.y = nu.y * -normal_force;
    normal.z = nu.z * -normal_force;
    only(in_contact, normal.x);
    only(in_contact, normal.y);
    only(in_contact, normal.z);
    // On the node F_n nu - F_t; the sums are of forces on the tool.
    const V total{normal.x + friction.x, normal.y + friction.y, normal.z + friction.z};
    force.x = zero - total.x;
    force.y = zero - total.y;
    force.z = zero - total.z;

    store(in_contact, f.in_contact + j);
    store(offset, f.offset + j);
    store(force, f.force[0] + j, f.force[1] + j, f.force[2] + j);
    store(step_stiffness, f.step_stiffness + j);
    if (f.full_report) {
        store(distance, f.distance + j);
        store(nu, f.normal[0] + j, f.normal[1] + j, f.normal[2] + j);
        store(point, f.point[0] + j, f.point[1] + j, f.point[2] + j);
        store(p_g, f.p_g + j);
        store(p, f.penetration + j);
        store(acting, f.acting + j);
        store(damping, f.damping + j);
        store(elastic, f.elastic + j);
        store(energy, f.energy + j);
        store(normal_force, f.normal_force + j);
        store(v, f.velocity[0] + j, f.velocity[1] + j, f.velocity[2] + j);
    }

    // The terms of the sums.
    const auto put = [&](Term term, const L& value) __attribute__((always_inline)) {
        store((L)((I)value & in_contact), block.row(term) + j);
    };
    const auto put_vector = [&](Term term, const V& value) __attribute__((always_inline)) {
        const int t = static_cast<int>(term);
        put(term, value.x);
        put(static_cast<Term>(t + 1), value.y);
        put(static_cast<Term>(t + 2), value.z);
    };
    V moment, sizes;
    cross_of(arm, total, moment);
    magnitude_of(normal.x, sizes.x);
    magnitude_of(normal.y, sizes.y);
    magnitude_of(normal.z, sizes.z);
    dot_of(total, total, square);
    root_of(square, length);
    put_vector(Term::normal_x, normal);
    put_vector(Term::abs_normal_x, sizes);
    put(Term::signed_normal, -normal_force);
    put(Term::norm_total, length);
    put(Term::damping_work, damping * vn * vn * c.step);
    put(Term::elastic_energy, energy);
    put_vector(Term::moment_x, moment);
    put(Term::step_stiffness, step_stiffness);
    dot_of(arm, arm, square);
    put(Term::step_rotation, step_stiffness * square);
    put(Term::stiffness, acting);
    put(Term::rotation, acting * square);
    if constexpr (has(Effects, effect::friction)) {
        magnitude_of(total.x, sizes.x);
        magnitude_of(total.y, sizes.y);
        magnitude_of(total.z, sizes.z);
        put_vector(Term::tangential_x, friction);
        put_vector(Term::abs_total_x, sizes);
        put_vector(Term::force_x, total);
        dot_of(v, friction, square);
        put(Term::friction_work, square * c.step);
    }
}

template <unsigned Effects, int W>
TYPE21_INLINE void act_all(const ForceCycle& c, const Search::Batch& at, ForceRows& f, TermBlock& block) {
    // Narrow registers, too, go as far as the sums do: there the terms of an earlier block may stand.
    const int columns = full_registers(f.count);
    for (int j = 0; j < columns; j += W)
        act<Effects, W>(c, at, f, j, block);
    block.resize(columns);
}

template <unsigned Effects>
TYPE21_AVX512 void act_eight(const ForceCycle& c, const Search::Batch& at, ForceRows& f, TermBlock& block) {
    act_all<Effects, 8>(c, at, f, block);
}
template <unsigned Effects>
TYPE21_AVX2 void act_four(const ForceCycle& c, const Search::Batch& at, ForceRows& f, TermBlock& block) {
    act_all<Effects, 4>(c, at, f, block);
}
template <unsigned Effects>
void act_two(const ForceCycle& c, const Search::Batch& at, ForceRows& f, TermBlock& block) {
    act_all<Effects, 2>(c, at, f, block);
}

template <unsigned Effects>
Forces forces_on(SimdWidth machine) {
    return compiled_for(machine, act_eight<Effects>, act_four<Effects>, act_two<Effects>);
}

}  // namespace

Forces forces_for(unsigned effects, SimdWidth machine) {
    constexpr unsigned damping = effect::damping, with_friction = effect::friction, pmax = effect::pmax,
                       law = effect::law;
    switch (effects & (damping | with_friction | pmax | law)) {
        case 0:
            return forces_on<0>(machine);
        case damping:
            return forces_on<damping>(machine);
        case with_friction:
            return forces_on<with_friction>(machine);
        case damping | with_friction:
            return forces_on<damping | with_friction>(machine);
        case pmax:
            return forces_on<pmax>(machine);
        case pmax | damping:
            return forces_on<pmax | damping>(machine);
        case pmax | with_friction:
            return forces_on<pmax | with_friction>(machine);
        case law | with_friction:
            return forces_on<law | with_friction>(machine);
        case law | with_friction | damping:
            return forces_on<law | with_friction | damping>(machine);
        case law | with_friction | pmax:
            return forces_on<law | with_friction | pmax>(machine);
        case law | with_friction | pmax | damping:
            return forces_on<law | with_friction | pmax | damping>(machine);
        default:
            return forces_on<damping | with_friction | pmax>(machine);
    }
}

}  // namespace type21::optimized
