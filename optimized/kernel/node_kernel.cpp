// One node in one cycle, in the order of the formulation. Effects are template arguments, so an absent one leaves no
// branch.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "optimized/kernel/contact_point.h"
#include "optimized/kernel/node_data.h"
#include "optimized/kernel/node_terms.h"
#include "optimized/kernel/normal_law.h"

namespace type21::optimized {

namespace {

/// Is an effect on? A constant, except in the kernel for any scene.
template <unsigned Effects>
bool on(const Laws& laws, unsigned one) {
    if constexpr ((Effects & effect::any) != 0) return laws.has(one);
    return (Effects & one) != 0;
}

void forget(const Laws& laws, NodeData& nodes, size_t i) {
    nodes.offset[i] = 0;
    nodes.cycles[i] = 0;
    if (!nodes.friction.empty()) nodes.friction[i] = {};
    static_cast<void>(laws);
}

/// T_m at the contact point: Tint, or that of the tool's nodes.
/// @manual field Ithe, Tint, Ithe_form
double tool_temperature(const Laws& laws, const Decision& d, const Motion& motion) {
    if (!laws.heat || !laws.heat->nodal_tool()) return laws.card->tint;
    const auto& node = laws.model->surfaces[static_cast<size_t>(laws.card->main_surface)]
                           .segments[static_cast<size_t>(d.segment)]
                           .node;
    const auto at = [&](int j) { return motion.temperature[static_cast<size_t>(node[static_cast<size_t>(j)])]; };
    const bool triangle = laws.tool.is_triangle(d.segment);
    const SubTriangleCorners corner = sub_triangle_corners(triangle, d.triangle);
    const double of_a = triangle ? at(2) : 0.25 * (at(0) + at(1) + at(2) + at(3));
    return (1 - d.b - d.c) * of_a + d.b * at(corner.b) + d.c * at(corner.c);
}

/// The heat of the tool's nodes: a quarter of a's share each, b and c; a triangle has no centre.
void heat_tool(const Laws& laws, const Decision& d, double heat, ChunkLists& lists) {
    const auto& node = laws.model->surfaces[static_cast<size_t>(laws.card->main_surface)]
                           .segments[static_cast<size_t>(d.segment)]
                           .node;
    const double a = 1 - d.b - d.c;
    const bool triangle = laws.tool.is_triangle(d.segment);
    const SubTriangleCorners corner = sub_triangle_corners(triangle, d.triangle);
    if (triangle) {
        lists.tool_heat.push_back({node[2], a * heat});
    } else {
        for (const int n : node)
            lists.tool_heat.push_back({n, 0.25 * a * heat});
    }
    lists.tool_heat.push_back({node[static_cast<size_t>(corner.b)], d.b * heat});
    lists.tool_heat.push_back({node[static_cast<size_t>(corner.c)], d.c * heat});
}

/// @manual field Ithe_form; comment 16; departure D16
void exchange_heat(const Laws& laws, const Cycle& cycle, size_t i, int model_node, const NodeContact& node,
                   NodeHeat& out, ChunkLists& lists) {
    const Motion& motion = cycle.motion;
    const double blank = motion.temperature[static_cast<size_t>(model_node)];
    const Heat heat = (*laws.heat)(static_cast<int>(i), node.distance, node.gap, node.normal_force, blank,
                                   tool_temperature(laws, node.decision, motion), motion.step);
    out.conductance = heat.conductance;
    out.radiant_conductance = heat.radiant;
    out.heat = heat.to_node + out.friction_heat;
    if (laws.heat->heats_tool())
        heat_tool(laws, node.decision, (laws.d16 ? out.friction_heat : 0.0) - heat.to_node, lists);
}

/// @manual eq 6, 7, 8, 12, 19; field Fric, fct_IDF, AscaleF, Pmax, ITlim, Fheat; comment 5, 12, 14, 18; departure D08
template <unsigned Effects>
void friction(const Laws& laws, const Cycle& cycle, NodeData& nodes, size_t i, bool acts, NodeContact& out,
              NodeHeat& heat, ChunkLists& lists) {
    const Interface& card = *laws.card;
    const V3 velocity = from(out.relative_velocity), nu = from(out.normal);
    const double k = acts ? nodes.increment_stiffness(i) : 0.0;
    const double area = card.secondary.area[i];
    double mu = 0;
    if ((Effects & effect::any) == 0 || laws.coulomb) {
        mu = card.fric;
    } else {
        double factor = 1;
        if (laws.friction_of_temperature != nullptr) {
            // D08: Tint always, and AscaleF unused.
            const double blank = cycle.motion.temperature[static_cast<size_t>(nodes.node[i])];
            const double mean =
                0.5 * (blank + (laws.d08 ? double(card.tint) : tool_temperature(laws, out.decision, cycle.motion)));
            const double abscissa = laws.d08 ? mean : card.ascalef * mean;
            factor = (*laws.friction_of_temperature)(abscissa);
            if (card.fric * factor < 0 && ++lists.below_zero.count == 1)
                lists.below_zero = {1, nodes.node[i], abscissa, card.fric * factor};
        }
        const double speed = norm(velocity - nu * dot(velocity, nu));
        mu = laws.friction_coefficient(static_cast<int>(i), out.decision.segment, out.normal_force, speed, factor,
                                       lists);
    }
    double limit = mu * std::abs(out.normal_force);
    if (on<Effects>(laws, effect::pmax) && card.itlim == 0) limit = std::min(limit, area * card.pmax / std::sqrt(3.0));
    const Tangential t =
        returned_to_limit(nodes.friction[i], velocity, cycle.filter * k * cycle.motion.friction_step, nu, limit);
    nodes.friction[i] = t.force;
    out.friction = to_vec3(t.force);
    out.status = t.slides ? Status::slip : Status::stick;
    if (on<Effects>(laws, effect::heat) && k > 0)
        heat.friction_heat = card.fheat * (dot(t.trial - t.force, t.force) / k);
    if (on<Effects>(laws, effect::lists) && laws.skid) {
        const double share = t.slides ? skid_share(norm(t.force), card.pskid, area) : 0.0;
        nodes.skid[i] = std::max(nodes.skid[i], share);
    }
}

/// Is contact searched for this node in this cycle? `inert`: it has neither stiffness nor heat.
enum class Activity { active, inert, deleted };

/// @manual field Idel
template <unsigned Effects>
Activity activity_of(const Laws& laws, const Cycle& cycle, const NodeData& nodes, size_t i) {
    if (nodes.stiffness[i] == 0 && !on<Effects>(laws, effect::heat)) return Activity::inert;
    const auto thickness = cycle.motion.thickness;
    if (!on<Effects>(laws, effect::rare) || !laws.deletion || thickness.empty()) return Activity::active;
    const auto shells = laws.deletion->at(static_cast<int>(i));
    const bool gone = !shells.empty() && std::all_of(shells.begin(), shells.end(),
                                                     [&](int s) { return thickness[static_cast<size_t>(s)] <= 0; });
    return gone ? Activity::deleted : Activity::active;
}

/// @return false where nothing is to be summed
/// @manual field VISs, IBC, Invn; comment 7, 21; departure D05
template <unsigned Effects>
bool node_step(const Laws& laws, const Cycle& cycle, NodeData& nodes, size_t i, const V3& y, Activity activity,
               const Retained& retained, NodeContact& out, NodeHeat& heat, ChunkLists& lists) {
    const Interface& card = *laws.card;
    const Motion& motion = cycle.motion;
    const ToolMotion& pose = cycle.pose;
    const bool heated = on<Effects>(laws, effect::heat);
    const bool rare = on<Effects>(laws, effect::rare), reports = on<Effects>(laws, effect::lists);
    const double gap = nodes.gap[i];
    out.gap = gap;
    if (activity == Activity::inert) return false;
    const int model_node = nodes.node[i];
    if (!retained.exists()) {
        if (!cycle.time_zero) forget(laws, nodes, i);
        return false;
    }
    out.decision = decision_of(retained);

    // Formulation 5, steps 1 to 4.
    const Vec3& position = motion.position[static_cast<size_t>(model_node)];
    const ContactPoint point = rare && laws.d12 ? contact_point_as_built(laws.tool, retained, y, position, pose)
                                                : contact_point(laws.tool, retained, pose);
    out.distance = point.distance;
    out.normal = to_vec3(point.normal);
    out.point = to_vec3(point.point);
    const bool is_contact = out.decision.kind == Kind::contact;
    // D11: a proximity node nearer than its gap has force, without a count and without an offset.
    const bool has_force = nodes.stiffness[i] != 0 && (is_contact || (rare && laws.d11));
    const double p_g = has_force ? penetration_beyond_rounding(gap, point.distance, largest(y)) : 0.0;
    out.geometric_penetration = p_g;
    if (!is_contact && nodes.cycles[i] > 0) forget(laws, nodes, i);
    if (p_g == 0) {
        // D33: at time 0 being retained counts as a cycle.
        if (rare && laws.d33 && cycle.time_zero && has_force && is_contact) nodes.cycles[i] = 1;
        if (!cycle.time_zero || nodes.cycles[i] == 0) {
            if (!cycle.time_zero) forget(laws, nodes, i);
            if (!heated) return false;
            exchange_heat(laws, cycle, i, model_node, out, heat, lists);
            return true;
        }
    } else if (is_contact) {
        ++nodes.cycles[i];
    }

    // Formulation 6, steps 2 to 4.
    const bool first = nodes.cycles[i] == 1;
    double offset = first && !cycle.time_zero ? p_g : nodes.offset[i];
    if (reports && laws.normals_test && first && p_g > gap + 0.99 * card.depth)
        lists.inverted.push_back({model_node, out.decision.segment, p_g});
    offset = offset_after(offset, cycle.inacti == 6, p_g, gap);
    nodes.offset[i] = offset;
    out.offset = offset;
    const double p = std::max(p_g - offset, 0.0);
    out.penetration = p;
    const bool forgiven = cycle.time_zero && (cycle.inacti == 5 || cycle.inacti == 6);
    const bool acts = p > 0 || (first && !forgiven);
    const double k = acts ? nodes.stiffness[i] : 0.0;
    out.stiffness = k;
    if (reports && laws.release && p > 0 && nodes.released[i] == 0) {
        nodes.released[i] = 1;
        lists.released.push_back(model_node);
    }

    // Formulation 7, steps 2 to 7.
    const V3 nu = point.normal;
    const V3 arm = point.point - from(pose.position);
    const V3 velocity = from(motion.velocity[static_cast<size_t>(model_node)]) -
                        (from(pose.velocity) + cross(from(pose.angular_velocity), arm));
    out.relative_velocity = to_vec3(velocity);
    const Spring spring =
        on<Effects>(laws, effect::pmax)
            ? yielding_spring(k, p, std::max(gap - card.secondary.gap[i], 0.0), card.secondary.area[i] * card.pmax)
            : linear_spring(k, p);
    out.elastic_force = spring.force;
    out.elastic_energy = spring.energy;
    // D05, Istf 1: Stfac to the power p^2.
    if (rare && laws.d05) out.elastic_energy = k != 0 ? std::pow(double(card.stfac), p * p) : 0.0;
    if (on<Effects>(laws, effect::damping)) out.damping = card.viss * std::sqrt(2 * k * nodes.mass[i]);
    out.normal_force = spring.force - out.damping * dot(velocity, nu);
    out.step_stiffness = motion.step > 0 ? k + out.damping / motion.step : k;

    // Formulation 8, steps 1 to 12, and heat.
    if (acts) out.status = Status::slip;
    if (on<Effects>(laws, effect::friction)) friction<Effects>(laws, cycle, nodes, i, acts, out, heat, lists);
    out.force = out.normal_force * out.normal - out.friction;
    if (heated) exchange_heat(laws, cycle, i, model_node, out, heat, lists);
    return true;
}

template <unsigned Effects>
void kernel(const Laws& laws, const Cycle& cycle, NodeData& nodes, int first, int last, const Output& output,
            ChunkLists& lists, Workspace& work) {
    work.nodes.resize(static_cast<size_t>(last - first));
    NodeContact* const out = output.node != nullptr ? output.node + first : work.nodes.data();
    const bool heated = on<Effects>(laws, effect::heat);
    const int terms = static_cast<int>(heated ? Term::heat_to_tool : Term::friction_heat);
    const Motion& motion = cycle.motion;
    Search::Batch& batch = *work.batch;
    batch.depth = laws.card->depth;
    batch.proximity = laws.proximity;
    batch.prefetcher = nullptr;  // an exception in a cycle before may have left one
    for (int start = first; start < last; start += Search::Batch::capacity) {
        // Positions and retained impacts (Formulation 1, step 1; Formulation 3, steps 1 to 6; Formulation 4, steps 1 to
        // 5). The transform is written as in the formulation, since its rounding is part of the position that decisions
        // are exact for.
        batch.count = std::min(Search::Batch::capacity, last - start);
        batch.memory = nodes.memory_from(start);
        batch.first = start;
        Activity activity[Search::Batch::capacity];
        for (int j = 0; j < batch.count; ++j) {
            const auto i = static_cast<size_t>(start + j);
            activity[j] = activity_of<Effects>(laws, cycle, nodes, i);
            batch.active[j] = activity[j] == Activity::active;
            const Vec3& position = motion.position[static_cast<size_t>(nodes.node[i])];
            const Vec3 at = cycle.pose.rotation.transpose() * (position - cycle.pose.position);
            for (int a = 0; a < 3; ++a)
                batch.y[a][j] = at[a];
            batch.gap[j] = nodes.deciding_gap(i);
        }
        laws.search->find(batch, laws.rules);
        work.tally.add(batch.tally);
        // A blank NodeContact is zero except for its Decision. One call for many nodes is cheaper than many calls.
        std::memset(static_cast<void*>(out + (start - first)), 0,
                    static_cast<size_t>(batch.count) * sizeof(NodeContact));
        for (int j = 0; j < batch.count; ++j) {
            const V3 y{batch.y[0][j], batch.y[1][j], batch.y[2][j]};
            NodeContact& node = out[start + j - first];
            node.decision = Decision{};
            NodeHeat unheated;
            NodeHeat& heat = heated ? (output.heat[start + j] = NodeHeat{}) : unheated;
            if (!node_step<Effects>(laws, cycle, nodes, static_cast<size_t>(start + j), y, activity[j],
                                    batch.retained(j), node, heat, lists))
                continue;
            add_terms(node, heated ? &heat : nullptr, motion.step, cycle.pose.position, work.terms);
            if (work.terms.size() < TermBlock::capacity) continue;
            work.sums.add(work.terms, terms);
            work.terms.clear();
        }
    }
    if (work.terms.size() > 0) {
        work.sums.add(work.terms, terms);
        work.terms.clear();
    }
    if (output.skid != nullptr) std::copy(nodes.skid.begin() + first, nodes.skid.begin() + last, output.skid + first);
    if (output.node == nullptr) {
        for (int i = first; i < last; ++i) {
            output.force[i] = out[i - first].force;
            output.step_stiffness[i] = out[i - first].step_stiffness;
        }
    }
    for (const ToolHeat& heat : lists.tool_heat)
        work.sums[Term::heat_to_tool].add(heat.heat);
}

}  // namespace

Kernel kernel_for(unsigned effects) {
    constexpr unsigned damping = effect::damping, with_friction = effect::friction, pmax = effect::pmax,
                       heat = effect::heat;
    switch (effects) {
        case 0:
            return kernel<0>;
        case damping:
            return kernel<damping>;
        case with_friction:
            return kernel<with_friction>;
        case damping | with_friction:
            return kernel<damping | with_friction>;
        case damping | with_friction | pmax:
            return kernel<damping | with_friction | pmax>;
        case damping | with_friction | heat:
            return kernel<damping | with_friction | heat>;
        default:
            return kernel<effect::any>;
    }
}

}  // namespace type21::optimized
