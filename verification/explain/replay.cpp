#include "verification/explain/replay.h"

#include <algorithm>
#include <cmath>

#include "reference/contact/normal_force.h"

namespace type21 {

using namespace reference;

namespace {

void replay_friction(const Interface& interface, const Inspect& inspect, int i, const Motion& motion,
                     const NodeContact& node, const NodeBefore& before, Replay& out) {
    out.has_friction = inspect.has(Effect::friction);
    if (!out.has_friction) return;
    out.input = inspect.friction_input(i, motion, node, out.acts);
    out.input.normal_force = out.normal_force;
    out.coefficient = inspect.friction_coefficient(i, out.input);
    out.filter = inspect.reading().filter_constant(interface, out.input.step);
    out.limit = std::min(out.coefficient * std::abs(out.normal_force), out.input.cap);
    out.friction = friction_force(before.friction, out.filter * out.input.stiffness, out.input.velocity, out.input.step,
                                  out.input.normal, out.limit);
    out.slip_energy = slip_energy(out.friction, out.input.stiffness);
}

}  // namespace

Replay replay(const Interface& interface, const Inspect& inspect, int i, const Motion& motion, const NodeContact& node,
              const NodeBefore& before) {
    Replay out;
    const bool time_zero = motion.time <= 0;
    const bool in_contact = node.decision.kind == Kind::contact;
    out.cycles = before.penetration.cycles;
    out.offset_before = before.penetration.offset;
    if (node.geometric_penetration == 0) {
        if (time_zero && in_contact && inspect.stiffness(i) != 0 && inspect.reading().counts_without_penetration)
            out.cycles = 1;
        out.impact = in_contact && time_zero && out.cycles > 0;
    } else {
        out.impact = true;
        if (in_contact) {
            ++out.cycles;
        } else {  // D11: without a count and without an offset
            out.cycles = 0;
            if (before.penetration.cycles > 0) out.offset_before = 0;
        }
    }
    if (!out.impact) return out;
    const Vec3 remembered = in_contact || before.penetration.cycles == 0 ? before.friction : Vec3(Vec3::Zero());

    if (out.cycles == 1 && !time_zero) out.offset_before = node.geometric_penetration;
    out.offset = relaxed_offset(out.offset_before, inspect.inacti(), node.geometric_penetration, node.gap);
    out.penetration = effective_penetration(node.geometric_penetration, out.offset);
    out.acts = stiffness_acts(out.penetration, out.cycles, inspect.inacti(), time_zero);
    out.stiffness = out.acts ? inspect.stiffness(i) : 0.0;

    out.normal_velocity = node.relative_velocity.dot(node.normal);
    out.elastic_force = elastic_force(out.stiffness, out.penetration);
    if (inspect.has(Effect::pmax_limit)) {
        out.pmax = inspect.pmax_limit(i);
        out.limited = limited(out.stiffness, out.pmax);
        out.elastic_force = limited_force(out.stiffness, out.penetration, out.pmax);
    }
    if (inspect.has(Effect::damping)) out.damping = damping_coefficient(interface.viss, out.stiffness, inspect.mass(i));
    out.normal_force = out.elastic_force - out.damping * out.normal_velocity;

    replay_friction(interface, inspect, i, motion, node, {before.penetration, remembered}, out);
    out.force = out.normal_force * node.normal - out.friction.force;
    return out;
}

}  // namespace type21
