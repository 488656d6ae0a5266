#include "verification/explain/node_account.h"

#include <fmt/format.h>

#include "reference/contact/gap_growth.h"
#include "reference/model/nodal_gaps.h"

namespace type21 {

using namespace reference;

std::string digits(double value) {
    return fmt::format("{:.9g}", value);
}

std::string digits(const Vec3& value) {
    return fmt::format("({:.9g}, {:.9g}, {:.9g})", value.x(), value.y(), value.z());
}

namespace {

/// g = ... by Igap, with the numbers of this node.
AccountLine gap_line(const AccountInput& input, double gap) {
    const Interface& card = input.card();
    const auto n = static_cast<size_t>(input.node);
    const SecondarySide& side = card.secondary;
    AccountLine line{"g", "Gapmin", "", gap, input.unit(dim::length), "Igap 0, manual page, comment 2"};
    if (card.igap == 0) return line;
    const double contact_thickness = side.contact_thickness[n];
    const char* const thickness = contact_thickness != 0 ? "t_c" : "t0";
    const double value = contact_thickness != 0 ? contact_thickness : side.thickness[n];
    if (card.igap == 1) {
        line.formula = fmt::format("max(Gapmin, min(Fscalegap {}/2, Gapmax))", thickness);
        line.numbers = fmt::format("max({:.6g}, min({:.6g} x {:.6g}/2, {:.6g}))", card.gapmin.value,
                                   card.fscalegap.value, value, card.gapmax.value);
        line.source = contact_thickness != 0 ? "manual page, equation (3)" : "manual page, equation (1)";
        return line;
    }
    const double raw = input.inspect.raw_gap(input.node, input.motion).value_or(gap);
    line.formula = fmt::format("max(Gapmin, min(g_s, Gapmax)), g_s = Fscalegap ({} + t_n - t0)/2", thickness);
    line.numbers = fmt::format("max({:.6g}, min({:.9g}, {:.6g}))", card.gapmin.value, raw, card.gapmax.value);
    line.source = contact_thickness != 0 ? "manual page, equation (4)" : "manual page, equation (2)";
    return line;
}

/// Equal in every bit, except for the sign of zeros.
bool same(const NodeContact& node, const Replay& replay) {
    if (!replay.impact) return node.force.isZero(0.0) && node.normal_force == 0;
    return node.offset == replay.offset && node.penetration == replay.penetration &&
           node.stiffness == replay.stiffness && node.damping == replay.damping &&
           node.elastic_force == replay.elastic_force && node.normal_force == replay.normal_force &&
           node.friction == replay.friction.force && node.force == replay.force;
}

}  // namespace

AccountSection place_section(const AccountInput& input) {
    const std::string length = input.unit(dim::length);
    const ToolMotion& pose = input.motion.tools[static_cast<size_t>(input.card().tool)];
    const Vec3& x = input.motion.position[static_cast<size_t>(input.model_node())];
    const ContactReach<double> reach = input.inspect.reach(input.node);
    AccountSection section{"place", {}};
    section.add("x", "", "", x, length, "position of the node");
    section.add("x_G", "", "", pose.position, length, "main node of the tool");
    section.add("y", "R^T (x - x_G)", "", input.inspect.tool_frame(input.node, input.motion), length,
                "Formulation 1, step 1");
    const double gap = input.step.active ? input.step.nodes[static_cast<size_t>(input.node)].gap : reach.gap;
    section.lines.push_back(gap_line(input, gap));
    const SecondarySide& side = input.card().secondary;
    const auto n = static_cast<size_t>(input.node);
    if (input.card().igap != 0 && side.thickness[n] == 0 && side.contact_thickness[n] == 0) {
        const bool is_void = nodes_of_void_shells(input.model())[static_cast<size_t>(input.model_node())];
        section.say("t0", is_void ? "0, for the shells at the node are void: void shells count without thickness"
                                  : "0, for the node belongs to no shell");
    }
    if (reach.gap != gap)
        section.add("g'", "", "", reach.gap, length, "D33: this gap decides whether there is contact");
    section.add("DEPTH", "", "", reach.depth, length, "manual page, comment 4");
    if (reach.proximity > 0)
        section.add("reach", "max(Drad, Dcond)", "", reach.proximity, length, "Formulation 3, step 5");
    return section;
}

NodeAccount account_node(const AccountInput& input) {
    NodeAccount account;
    account.interface = input.card().id;
    account.interface_title = input.card().title;
    account.active = input.step.active;
    account.place = place_section(input);
    account.candidates =
        account_candidates(input.inspect, input.node, input.inspect.tool_frame(input.node, input.motion));
    if (!account.active) {
        AccountSection section{"no contact", {}};
        section.say("", "the interface is not active at this time (Tstart, Tstop, sens_ID)", "manual page, comment 20");
        account.sections.push_back(std::move(section));
        return account;
    }
    const NodeContact& node = account.node = input.step.nodes[static_cast<size_t>(input.node)];
    account.replay = replay(input.card(), input.inspect, input.node, input.motion, node, input.before);
    account.agrees = same(node, account.replay);
    account.sections.push_back(impact_section(input, account));
    if (node.decision.kind == Kind::none) return account;
    account.sections.push_back(geometry_section(input, node));
    if (account.replay.impact) {
        account.sections.push_back(offset_section(input, node, account.replay));
        account.sections.push_back(normal_section(input, node, account.replay));
        account.sections.push_back(friction_section(input, node, account.replay));
    }
    if (input.inspect.heat_exchange()) account.sections.push_back(heat_section(input, node));
    account.sections.push_back(force_section(input, account));
    return account;
}

}  // namespace type21
