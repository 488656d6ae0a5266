// Decisions, tested against the exact answers of cases/decisions.
#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/criteria/mutation/mutation.h"
#include "verification/decisions/queries/decide.h"

namespace type21 {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double above(double value) {
    return std::nextafter(value, infinite);
}

/// The reference, asked another query.
BreakDecision asked(const std::function<void(ContactQuery&)>& change) {
    return [=](const DecisionTool& tool, const ContactQuery& query) {
        ContactQuery changed = query;
        change(changed);
        return decide(tool, changed, DecideWith::reference);
    };
}

/// Segments in the opposite order: the higher rank wins a tie.
DecisionAnswer ties_reversed(const DecisionTool& tool, const ContactQuery& query) {
    DecisionTool turned = tool;
    std::reverse(turned.segment.begin(), turned.segment.end());
    DecisionAnswer answer = decide(turned, query, DecideWith::reference);
    if (answer.segment >= 0) answer.segment = static_cast<int>(tool.segment.size()) - 1 - answer.segment;
    return answer;
}

/// The search misses the segment that should be retained.
DecisionAnswer candidate_dropped(const DecisionTool& tool, const ContactQuery& query) {
    const DecisionAnswer sound = decide(tool, query, DecideWith::reference);
    if (sound.segment < 0) return sound;
    DecisionTool holed = tool;
    auto& corner = holed.segment[static_cast<size_t>(sound.segment)];
    corner = {corner[0], corner[0], corner[0], corner[0]};  // no area: takes nothing
    return decide(holed, query, DecideWith::reference);
}

DecisionAnswer normals_flipped(const DecisionTool& tool, const ContactQuery& query) {
    DecisionTool flipped = tool;
    for (Vec3& normal : flipped.normal)
        normal = -normal;
    return decide(flipped, query, DecideWith::reference);
}

DecisionAnswer in_double(const DecisionTool& tool, const ContactQuery& query) {
    return decide(tool, query, DecideWith::plain);
}

DecisionAnswer side_reversed(const DecisionTool& tool, const ContactQuery& query) {
    DecisionAnswer answer = decide(tool, query, DecideWith::reference);
    answer.side = -answer.side;
    return answer;
}

}  // namespace

std::vector<Mutation> decision_mutations() {
    const std::string kappa = "retained impact, kappa";
    return {
        {"gap_one_ulp",
         "acceptance, d < g",
         "the gap is one unit in the last place larger",
         {},
         {},
         asked([](ContactQuery& q) { q.gap = above(q.gap); })},
        {"depth_one_ulp",
         "acceptance, DEPTH",
         "DEPTH is one unit in the last place larger",
         {},
         {},
         asked([](ContactQuery& q) { q.depth = above(q.depth); })},
        {"reach_one_ulp",
         "proximity, Drad",
         "the reach of heat exchange is one unit in the last place larger",
         {},
         {},
         asked([](ContactQuery& q) { q.proximity_reach = q.proximity_reach > 0 ? above(q.proximity_reach) : 0.0; })},
        {"low_border_one_ulp",
         "border, b and c >= -0.01",
         "the limit -0.01 is one unit in the last place higher",
         {},
         {},
         asked([](ContactQuery& q) { q.lowest_weight = above(q.lowest_weight); })},
        {"high_border_one_ulp",
         "border, b + c <= 1.01",
         "the limit 1.01 is one unit in the last place lower",
         {},
         {},
         asked([](ContactQuery& q) { q.highest_weight_sum = std::nextafter(q.highest_weight_sum, 0.0); })},
        {"tie_reversed", kappa, "the higher segment wins a tie", {}, {}, ties_reversed},
        {"proximity_competes", kappa, "proximity competes with contact", {}, {}, asked([](ContactQuery& q) {
             q.proximity_competes = true;
         })},
        {"leaning_lifted",
         "projection, step 1",
         "corners are lifted also along normals that lean away from the triangle",
         {},
         {},
         asked([](ContactQuery& q) { q.lift_leaning = true; })},
        {"candidate_dropped",
         "search",
         "the segment that should be retained is not among the candidates",
         {},
         {},
         candidate_dropped},
        {"normals_flipped", "projection, nodal normals", "the nodal normals point inward", {}, {}, normals_flipped},
        {"exactness_off", "exact decisions", "all decisions in plain double arithmetic", {}, {}, in_double},
        {"side_reversed", "side of the plane", "outward and behind are exchanged", {}, {}, side_reversed},
    };
}

}  // namespace type21
