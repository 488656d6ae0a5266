/// @file The retained impact, the contact point, and the penetration offset: chapters 4 to 6 of the formulation.
#include <fmt/format.h>

#include "reference/exact/staged_impact.h"
#include "verification/decisions/queries/decide.h"
#include "verification/explain/node_account.h"

namespace type21 {

using namespace reference;

namespace {

std::string side_text(int side) {
    return side < 0 ? "behind the surface" : "outward";
}

/// Why no impact is retained.
std::string no_impact(const AccountInput& input, const CandidateAccount& candidates) {
    if (input.inspect.deleted(input.node, input.motion))
        return "all elements at the node are deleted, so it has left the interface (Idel)";
    if (input.inspect.stiffness(input.node) == 0 && input.inspect.inacti() == 1)
        return "the node penetrated at time 0 and is switched off (Inacti 1)";
    if (input.inspect.stiffness(input.node) == 0) return "the node has no stiffness (k = 0)";
    if (candidates.segments.empty()) return "no segment is near enough, so there is no contact";
    if (candidates.taken > 0)
        return "no contact: exact arithmetic rejects the sub-triangle that the rounded numbers above accept";
    return "every sub-triangle rejects the node, so there is no contact";
}

/// The numbers above are doubles. If their rounding matters, the exact decision differs.
std::string by_exact_arithmetic(const Impact<double>& of_doubles) {
    if (of_doubles.kind == Kind::none)
        return "exact arithmetic accepts the sub-triangle that the rounded numbers above reject";
    return fmt::format("exact arithmetic; the rounded numbers above would retain segment {}, k = {}",
                       of_doubles.segment + 1, of_doubles.triangle);
}

/// The stage that settled the decision, and its margin.
std::string settled_text(const AccountInput& input, const NodeAccount& account, const std::string& length) {
    const Vec3 y = input.inspect.tool_frame(input.node, input.motion);
    const std::vector<int> segments = input.inspect.candidates(input.node, y);
    const ShapeOf shape_of = [&](int segment) { return input.inspect.shape(segment); };
    const ContactQuery query =
        query_of(y, input.inspect.reach(input.node), input.inspect.limits(), input.inspect.proximity_competes());
    const double margin = decision_margin(query, {segments, shape_of});
    return fmt::format("{}; margin to another decision {:.3g} {}, {:.3g} ulp", name(account.node.decision.stage),
                       margin, length, in_ulps(margin, y));
}

}  // namespace

AccountSection impact_section(const AccountInput& input, const NodeAccount& account) {
    const Decision& decision = account.node.decision;
    AccountSection section{"retained impact", {}};
    const std::string length = input.unit(dim::length);
    if (decision.kind == Kind::none) {
        section.say("", no_impact(input, account.candidates), "Formulation 4, step 5");
        return section;
    }
    std::string nodes;
    const auto& corner = input.inspect.segment_nodes(decision.segment);
    for (size_t j = 0; j < (corner[2] == corner[3] ? 3u : 4u); ++j)
        nodes += fmt::format("{}{}", j > 0 ? " " : "", input.model().nodes.id[static_cast<size_t>(corner[j])]);
    section.say("segment",
                fmt::format("{} (nodes {}), k = {}, {}, {}", decision.segment + 1, nodes, decision.triangle,
                            decision.kind == Kind::contact ? "contact" : "proximity", side_text(decision.side)),
                "Formulation 4, step 5");
    const Impact<double>& ours = account.candidates.retained;
    const bool same =
        ours.segment == decision.segment && ours.triangle == decision.triangle && ours.kind == decision.kind;
    section.say("why", same ? account.candidates.why : by_exact_arithmetic(ours), "Formulation 4, step 3");
    section.say("settled by", settled_text(input, account, length), "Formulation 10, step 8");
    section.say("a, b, c", fmt::format("{:.9g}, {:.9g}, {:.9g}", 1.0 - decision.b - decision.c, decision.b, decision.c),
                "Formulation 3, step 3");
    return section;
}

AccountSection geometry_section(const AccountInput& input, const NodeContact& node) {
    const std::string length = input.unit(dim::length);
    AccountSection section{"contact geometry", {}};
    const bool d12 = input.model().as_built.has(Departure::D12);
    section.add("X", "a A + b B + c C", "", node.point, length, "Formulation 5, step 1");
    section.add("nu", d12 ? "(x - X)/|x - X|, outward" : "n/|n|, outward", "", node.normal, "",
                d12 ? "D12" : "Formulation 5, step 2");
    section.add("delta", d12 ? "|x - X|, negative behind" : "H |n|/<n,N>, along nu", "", node.distance, length,
                d12 ? "D12" : "Formulation 5, step 3");
    section.add("p_g", "max(0, g - delta)", fmt::format("max(0, {} - {})", digits(node.gap), digits(node.distance)),
                node.geometric_penetration, length, "Formulation 5, step 4");
    if (node.geometric_penetration > 0) return section;
    if (node.decision.kind == Kind::proximity) {
        section.say("", "proximity: no force, only heat", "Formulation 4, step 2");
    } else {
        section.say("", "no penetration: no force, and the history of the node is reset", "Formulation 6, step 5");
    }
    return section;
}

AccountSection offset_section(const AccountInput& input, const NodeContact& node, const Replay& replay) {
    const std::string length = input.unit(dim::length);
    AccountSection section{fmt::format("penetration offset, cycle {} of this impact", replay.cycles), {}};
    const int inacti = input.inspect.inacti();
    const bool six = inacti == 6;
    const bool time_zero = input.motion.time <= 0;
    const double before = replay.offset_before;
    if (replay.cycles == 1 && !time_zero) {
        section.add("P0 old", "p_g, first impact", "", before, length, "Formulation 6, step 2");
    } else if (time_zero && (inacti == 5 || six)) {
        section.add("P0 old", six ? "p_g + 0.05 (g + DEPTH - p_g)" : "p_g", "", before, length,
                    fmt::format("Inacti {}, manual page, comment 9", inacti));
    } else {
        section.add("P0 old", time_zero ? "0" : "", "", before, length,
                    time_zero ? "Inacti 0" : "from the cycle before");
    }
    section.add(
        "P0", six ? "min(P0, 0.95 P0 + 0.05 (p_g + 0.05|g - p_g|))" : "min(P0, 0.95 P0 + 0.05 p_g)",
        six ? fmt::format("min({0}, 0.95 x {0} + 0.05 x ({1} + 0.05 x |{2} - {1}|))", digits(before),
                          digits(node.geometric_penetration), digits(node.gap))
            : fmt::format("min({0}, 0.95 x {0} + 0.05 x {1})", digits(before), digits(node.geometric_penetration)),
        node.offset, length, "Formulation 6, step 3");
    section.add("p", "max(0, p_g - P0)",
                fmt::format("max(0, {} - {})", digits(node.geometric_penetration), digits(node.offset)),
                node.penetration, length, "Formulation 6, step 3");
    if (!replay.acts) section.say("", "p = 0: stiffness and damping are zero", "Formulation 6, step 4");
    return section;
}

}  // namespace type21
