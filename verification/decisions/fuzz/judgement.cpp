#include "verification/decisions/fuzz/judgement.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "verification/decisions/fuzz/second_opinion.h"
#include "verification/decisions/queries/decision_text.h"
#include "verification/decisions/queries/tool_candidates.h"

namespace type21 {

namespace {

/// Coordinates up to 1e60 and down to 1e-60: a height is a volume, and does not fit into a double far beyond.
bool magnitudes_fit(const DecisionTool& tool, const ContactQuery& query) {
    const auto fits = [](const Vec3& x) {
        return x.cwiseAbs().maxCoeff() < 1e60 && (x.array() == 0 || x.array().abs() > 1e-60).all();
    };
    return fits(query.point) && std::all_of(tool.node.begin(), tool.node.end(), fits);
}

/// Of the retained projection: weights and normal always, height and slope where a double can hold them.
std::optional<std::string> magnitudes(const DecisionTool& tool, const ContactQuery& query) {
    const ToolCandidates candidates(tool, query);
    const reference::StagedImpact impact = staged_impact(query, candidates.segments());
    if (impact.kind == Kind::none) return std::nullopt;
    const auto& projection = impact.projection;
    if (!std::isfinite(projection.weights.b) || !std::isfinite(projection.weights.c) || !projection.normal.allFinite())
        return fmt::format("the weights are {}, {}, the normal is {}, {}, {}", projection.weights.b,
                           projection.weights.c, projection.normal.x(), projection.normal.y(), projection.normal.z());
    if (magnitudes_fit(tool, query) && !(std::isfinite(projection.height) && projection.slope > 0))
        return fmt::format("height {} and slope {}", projection.height, projection.slope);
    return std::nullopt;
}

std::optional<std::string> reverse_order(const DecisionTool& tool, const ContactQuery& query,
                                         const DecisionAnswer& answer) {
    std::vector<int> segments = segments_near(tool, query);
    std::reverse(segments.begin(), segments.end());
    const ToolCandidates candidates(tool, segments);
    const reference::StagedImpact impact = staged_impact(query, candidates.segments());
    const DecisionAnswer other{impact.kind, impact.segment, impact.triangle, impact.side, impact.stage, 0, 0};
    if (other.same_decision(answer)) return std::nullopt;
    return fmt::format("candidates in reverse order: {}; in order: {}", in_words(other), in_words(answer));
}

std::optional<std::string> in_full(const DecisionTool& tool, const ContactQuery& query, DecideWith method,
                                   const Judgement& judgement) {
    const DecisionAnswer rational = decide(tool, query, DecideWith::exact);
    if (!rational.same_decision(judgement.answer))
        return fmt::format("{}; rational numbers: {}", in_words(judgement.answer), in_words(rational));
    if (method == DecideWith::reference) {
        if (const auto what = reverse_order(tool, query, judgement.answer)) return what;
        if (const auto what = magnitudes(tool, query)) return what;
    }
    if (!(judgement.margin >= 0)) return fmt::format("the margin is {}", judgement.margin);
    return std::nullopt;
}

}  // namespace

Judgement judge(const DecisionTool& tool, const ContactQuery& query, DecideWith method, Scrutiny scrutiny) {
    Judgement judgement;
    try {
        judgement.expected = second_opinion(tool, query);
        judgement.answer = decide(tool, query, method);
        if (!judgement.answer.same_decision(judgement.expected)) {
            judgement.wrong = fmt::format("{}; exact: {}", in_words(judgement.answer), in_words(judgement.expected));
        } else if (scrutiny == Scrutiny::full) {
            judgement.margin = margin(tool, query);
            judgement.wrong = in_full(tool, query, method, judgement).value_or("");
        }
    } catch (const std::exception& error) {
        judgement.wrong = fmt::format("threw: {}", error.what());
    }
    return judgement;
}

}  // namespace type21
