// Gap, offset, stiffness, normal force, Pmax, activity (chapters 2, 5, 6 and 7 of the formulation).
#include <algorithm>
#include <numeric>

#include "verification/criteria/mutation/break_contact.h"

namespace type21 {

namespace {

constexpr double part_in_a_million = 1 + 1e-6;

void scale(std::vector<double>& values, double by) {
    for (double& value : values)
        value *= by;
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(std::max<size_t>(values.size(), 1));
}

bool distorted(const Interface& card) {
    const auto& area = card.secondary.area;
    return !area.empty() &&
           *std::max_element(area.begin(), area.end()) > 1.01 * *std::min_element(area.begin(), area.end());
}

void open(NodeContact& node) {
    NodeContact none;
    none.gap = node.gap;
    node = none;
}

/// In one cycle of ten every node loses its retained segment.
BreakStep lose_contact(const Scene& scene, int interface) {
    return [&card = scene.model->interfaces[static_cast<size_t>(interface)], model = scene.model, cycle = 0](
               ContactStep& step, const Motion& motion) mutable {
        if (++cycle % 10 != 0) return;
        for (NodeContact& node : step.nodes)
            open(node);
        sum_again(step, motion, card);
    };
}

/// The offset stays what it was in the first cycle of contact: the force is k (p_g - P0 of then).
BreakStep keep_offset(const Scene& scene, int interface) {
    return [&card = scene.model->interfaces[static_cast<size_t>(interface)], model = scene.model,
            first = std::vector<double>()](ContactStep& step, const Motion& motion) mutable {
        first.resize(step.nodes.size(), -1.0);
        for (size_t i = 0; i < step.nodes.size(); ++i) {
            NodeContact& node = step.nodes[i];
            if (node.geometric_penetration <= 0) {
                first[i] = -1;
                continue;
            }
            if (first[i] < 0) first[i] = node.offset;
            const double p = std::max(0.0, node.geometric_penetration - first[i]);
            const double change = node.stiffness * (p - node.penetration);
            node.penetration = p;
            node.normal_force += change;
            node.force += change * node.normal;
        }
        sum_again(step, motion, card);
    };
}

}  // namespace

std::vector<Mutation> force_mutations() {
    using enum Effect;
    const auto always = has_effect(elastic);
    const auto changed = [](auto change) { return broken_card([=](ContactModel&, Interface& card) { change(card); }); };
    return {
        {"contact_lost",
         "retained impact",
         "in one cycle of ten every node loses its segment",
         always,
         broken_step(lose_contact),
         {}},
        {"normal_reversed",
         "contact geometry, nu",
         "nu points inward",
         always,
         broken_nodes([](NodeContact& n) {
             n.normal = -n.normal;
             n.force = n.normal_force * n.normal - n.friction;
         }),
         {}},
        {"gap_millionth",
         "gap g",
         "each gap is larger by a millionth",
         has_card([](const Interface& c) { return c.igap != 2; }),
         changed([](Interface& c) {
             scale(c.secondary.gap, part_in_a_million);
             scale(c.secondary.search_gap, part_in_a_million);
         }),
         {}},
        {"gaps_equal",
         "nodal gaps, Igap 1",
         "each node has the mean gap",
         has_card([](const Interface& c) { return c.igap == 1; }),
         changed([](Interface& c) {
             c.secondary.gap.assign(c.secondary.gap.size(), mean(c.secondary.gap));
             c.secondary.search_gap = c.secondary.gap;
         }),
         {}},
        {"depth_ignored",
         "DEPTH",
         "DEPTH is a tenth of that on the card",
         always,
         changed([](Interface& c) { c.depth.value *= 0.1; }),
         {}},
        {"gap_growth_off",
         "eq. of the gap, Igap 2",
         "the gap does not follow the thickness",
         has_effect(gap_growth),
         broken_card([](ContactModel&, Interface& c) { c.igap.value = 1; }),
         {}},
        {"deletion_off", "Idel", "nodes of deleted elements stay", has_effect(deletion), without_effect(deletion), {}},
        {"release_off", "IBC", "no condition is lifted", has_effect(release_bcs), without_effect(release_bcs), {}},
        {"normals_test_off",
         "Invn",
         "an impact from behind is not reported",
         has_effect(normals_test),
         without_effect(normals_test),
         {}},
        {"offset_kept", "P0, comment 9", "the offset is not relaxed", always, broken_step(keep_offset), {}},
        {"inacti_forgotten",
         "Inacti 5, 6",
         "penetrations at time 0 give no offset",
         has_effect(initial_offset),
         changed([](Interface& c) { c.inacti.value = 0; }),
         {}},
        {"inacti_1_ignored",
         "Inacti 1",
         "nodes that penetrate at time 0 keep their stiffness",
         has_card([](const Interface& c) { return c.inacti == 1; }),
         changed([](Interface& c) { c.inacti.value = 0; }),
         {}},
        {"inacti_5_as_6",
         "Inacti 5",
         "Inacti 5 is read as 6",
         has_card([](const Interface& c) { return c.inacti == 5; }),
         changed([](Interface& c) { c.inacti.value = 6; }),
         {}},
        {"stiffness_millionth",
         "k = Stfac S, eq. 1",
         "the stiffness is larger by a millionth",
         always,
         changed([](Interface& c) {
             scale(c.secondary.element_stiffness, part_in_a_million);
             if (c.istf == 1) c.stfac.value *= part_in_a_million;
         }),
         {}},
        {"stiffness_by_area",
         "equal nodal stiffness",
         "k in proportion to the node's area",
         has_card([](const Interface& c) { return c.istf != 1 && distorted(c); }),
         changed([](Interface& c) {
             const double one = mean(c.secondary.area);
             for (size_t i = 0; i < c.secondary.area.size(); ++i)
                 c.secondary.element_stiffness[i] *= c.secondary.area[i] / one;
         }),
         {}},
        {"stmin_ignored",
         "Stmin",
         "no least stiffness",
         has_card([](const Interface& c) { return c.stmin > 0; }),
         changed([](Interface& c) { c.stmin.value = 0; }),
         {}},
        {"stmax_ignored",
         "Stmax",
         "no largest stiffness",
         has_card([](const Interface& c) { return c.stmax < 1e30; }),
         changed([](Interface& c) { c.stmax.value = 1e30; }),
         {}},
        {"damping_off", "C = VISs sqrt(2 k m)", "no contact damping", has_effect(damping), without_effect(damping), {}},
        {"damping_millionth",
         "C = VISs sqrt(2 k m)",
         "the damping is larger by a millionth",
         has_effect(damping),
         changed([](Interface& c) { c.viss.value *= part_in_a_million; }),
         {}},
        {"pmax_infinite", "Pmax", "no limit of the pressure", has_effect(pmax_limit), without_effect(pmax_limit), {}},
        {"pmax_millionth",
         "Pmax",
         "the limit is higher by a millionth",
         has_effect(pmax_limit),
         changed([](Interface& c) { c.pmax.value *= part_in_a_million; }),
         {}},
        {"areas_equal",
         "A Pmax",
         "each node has the mean area",
         [](const Scene& s, int i) {
             return s.has(i, pmax_limit) && distorted(s.model->interfaces[static_cast<size_t>(i)]);
         },
         changed([](Interface& c) { c.secondary.area.assign(c.secondary.area.size(), mean(c.secondary.area)); }),
         {}},
        {"itlim_ignored",
         "ITlim",
         "ITlim 0 and 1 are exchanged",
         [](const Scene& s, int i) { return s.has(i, pmax_limit) && s.has(i, friction); },
         changed([](Interface& c) { c.itlim.value = 1 - c.itlim.value; }),
         {}},
        {"sensor_ignored",
         "sens_ID",
         "the sensor is ignored",
         has_card([](const Interface& c) { return c.sensor >= 0; }),
         changed([](Interface& c) { c.sensor = -1; }),
         {}},
        {"tstart_ignored",
         "Tstart",
         "active from time 0",
         has_card([](const Interface& c) { return c.sensor < 0 && c.tstart > 0; }),
         changed([](Interface& c) { c.tstart.value = 0; }),
         {}},
        {"tstop_ignored",
         "Tstop",
         "active to the end",
         has_card([](const Interface& c) { return c.sensor < 0 && c.tstop < 1e30; }),
         changed([](Interface& c) { c.tstop.value = 1e30; }),
         {}},
        {"adaptive_off",
         "Iadm",
         "no data for adaptive meshing",
         has_effect(adaptive_data),
         without_effect(adaptive_data),
         {}},
        {"step_stiffness_off",
         "time step, k + C/dt1",
         "the nodes do not limit the time step",
         own_step,
         broken_step([](const Scene&, int) {
             return [](ContactStep& step, const Motion&) {
                 for (NodeContact& node : step.nodes)
                     node.step_stiffness = 0;
             };
         }),
         {}},
    };
}

}  // namespace type21
