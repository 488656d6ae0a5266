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

/// The reference, asked a changed question.
BreakDecision asked(const std::function<void(DecisionQuery&)>& change) {
    return [=](const DecisionTool& tool, const DecisionQuery& query) {
        DecisionQuery changed = query;
        change(changed);
        return decide(tool, changed, DecideWith::reference);
    };
}

BreakDecision ruled(const DecisionRules& rules) {
    return [=](const DecisionTool& tool, const DecisionQuery& query) { return decide_by(tool, query, rules); };
}

/// Segments in the opposite order: the higher rank wins a tie.
DecisionAnswer ties_reversed(const DecisionTool& tool, const DecisionQuery& query) {
    DecisionTool turned = tool;
    std::reverse(turned.segment.begin(), turned.segment.end());
    DecisionAnswer answer = decide(turned, query, DecideWith::reference);
    if (answer.segment >= 0) answer.segment = static_cast<int>(tool.segment.size()) - 1 - answer.segment;
    return answer;
}

/// The search misses the segment that should be retained.
DecisionAnswer candidate_dropped(const DecisionTool& tool, const DecisionQuery& query) {
    const DecisionAnswer sound = decide(tool, query, DecideWith::reference);
    if (sound.segment < 0) return sound;
    DecisionTool holed = tool;
    auto& corner = holed.segment[static_cast<size_t>(sound.segment)];
    corner = {corner[0], corner[0], corner[0], corner[0]};  // no area: takes nothing
    return decide(holed, query, DecideWith::reference);
}

DecisionAnswer normals_flipped(const DecisionTool& tool, const DecisionQuery& query) {
    DecisionTool flipped = tool;
    for (Vec3& normal : flipped.normal)
        normal = -normal;
    return decide(flipped, query, DecideWith::reference);
}

DecisionAnswer in_double(const DecisionTool& tool, const DecisionQuery& query) {
    return decide(tool, query, DecideWith::plain);
}

DecisionAnswer side_reversed(const DecisionTool& tool, const DecisionQuery& query) {
    DecisionAnswer answer = decide(tool, query, DecideWith::reference);
    answer.side = -answer.side;
    return answer;
}

}  // namespace

std::vector<Mutation> decision_mutations() {
    DecisionRules low, high, competing, leaning;
    low.limits.low = above(low.limits.low);
    high.limits.high = std::nextafter(high.limits.high, 0.0);
    competing.proximity_competes = true;
    leaning.limits.lift_leaning = true;
    const std::string kappa = "retained impact, kappa";
    return {
        {"gap_one_ulp",
         "acceptance, d < g",
         "the gap is one unit in the last place larger",
         {},
         {},
         asked([](DecisionQuery& q) { q.gap = above(q.gap); })},
        {"depth_one_ulp",
         "acceptance, DEPTH",
         "DEPTH is one unit in the last place larger",
         {},
         {},
         asked([](DecisionQuery& q) { q.depth = above(q.depth); })},
        {"reach_one_ulp",
         "proximity, Drad",
         "the reach of heat exchange is one unit in the last place larger",
         {},
         {},
         asked([](DecisionQuery& q) { q.reach = q.reach > 0 ? above(q.reach) : 0.0; })},
        {"low_border_one_ulp",
         "border, b and c >= -0.01",
         "the limit -0.01 is one unit in the last place higher",
         {},
         {},
         ruled(low)},
        {"high_border_one_ulp",
         "border, b + c <= 1.01",
         "the limit 1.01 is one unit in the last place lower",
         {},
         {},
         ruled(high)},
        {"tie_reversed", kappa, "the higher segment wins a tie", {}, {}, ties_reversed},
        {"proximity_competes", kappa, "proximity competes with contact", {}, {}, ruled(competing)},
        {"leaning_lifted",
         "projection, step 1",
         "corners are lifted also along normals that lean away from the triangle",
         {},
         {},
         ruled(leaning)},
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
