#include "verification/decisions/fuzz/failure_file.h"

#include <functional>
#include <optional>

#include <fmt/format.h>

#include "reference/exact/impact_enclosure.h"
#include "verification/decisions/fuzz/judgement.h"
#include "verification/decisions/fuzz/second_opinion.h"
#include "verification/decisions/queries/decision_json.h"
#include "verification/decisions/queries/decision_text.h"
#include "verification/decisions/queries/tool_candidates.h"

namespace type21 {

namespace {

using Enclose = std::function<std::optional<reference::ImpactEnclosure>(const reference::SegmentShape<double>& shape,
                                                                        int segment, int k)>;

/// The retained impact in one arithmetic; nothing where it cannot tell.
std::optional<DecisionAnswer> retained_by(const ToolCandidates& candidates, const Enclose& enclose) {
    reference::ImpactEnclosure best;
    for (const int segment : candidates.ranks()) {
        const auto shape = candidates.segments().shape_of(segment);
        for (int k = 1; k <= shape.sub_triangles(); ++k) {
            const auto one = enclose(shape, segment, k);
            if (!one) return std::nullopt;
            if (one->kind == Kind::none) continue;
            const int kinds = reference::order_of_kinds(one->kind, best.kind);
            if (kinds == 0 && !(one->kappa_high < best.kappa_low) && !(best.kappa_high < one->kappa_low))
                return std::nullopt;
            if (kinds < 0 || (kinds == 0 && one->kappa_high < best.kappa_low)) best = *one;
        }
    }
    return DecisionAnswer{best.kind, best.segment, best.triangle, best.side, Stage::bounded, 0, 0};
}

std::string in_words(const std::optional<DecisionAnswer>& answer) {
    return answer ? type21::in_words(*answer) : "cannot tell";
}

}  // namespace

nlohmann::ordered_json failure_json(const FuzzFailure& failure, const std::string& family, const FuzzOptions& options) {
    const auto fails = [&](const SingleQuery& single) {
        return !judge(single.tool, single.query, options.method, Scrutiny::full).wrong.empty();
    };
    const SingleQuery small = shrink({failure.tool, failure.query}, fails);
    const Judgement judgement = judge(small.tool, small.query, options.method, Scrutiny::full);
    DecisionFile file;
    file.family = family;
    file.blocks.push_back({small.tool, {small.query}, {judgement.expected}});
    nlohmann::ordered_json json = to_json(file);
    json["blocks"][0]["answers"][0].erase("stage");
    json["blocks"][0]["answers"][0].erase("margin");
    json["blocks"][0]["answers"][0].erase("margin_ulps");
    json["with"] = name(options.method);
    json["what"] = judgement.wrong;
    json["found"] = {{"family", family}, {"seed", options.seed}, {"block", failure.block}, {"query", failure.number}};
    return json;
}

std::string every_answer(const DecisionTool& tool, const ContactQuery& query) {
    const ToolCandidates candidates(tool, query);
    const auto by_bound = [&](const auto& shape, int segment, int k) {
        return reference::enclosed_by_bound(query, shape, segment, k);
    };
    const auto by_interval = [&](const auto& shape, int segment, int k) {
        return reference::enclosed_by_interval(query, shape, segment, k);
    };
    const DecisionAnswer staged = decide(tool, query, DecideWith::reference);
    std::string text;
    const auto line = [&](std::string_view how, const std::string& answer) {
        text += fmt::format("  {:<20} {}\n", how, answer);
    };
    line("plain double", in_words(decide(tool, query, DecideWith::plain)));
    line("double with a bound", in_words(retained_by(candidates, by_bound)));
    line("interval", in_words(retained_by(candidates, by_interval)));
    line("rational numbers", in_words(decide(tool, query, DecideWith::exact)));
    line("reference", fmt::format("{}; settled by {}", in_words(staged), name(staged.stage)));
    for (const DecideWith method : {DecideWith::optimized, DecideWith::by_tree, DecideWith::by_sorting})
        line(name(method), in_words(decide(tool, query, method)));
    line("second opinion", in_words(second_opinion(tool, query)));
    const double how_far = margin(tool, query);
    line("margin", fmt::format("{:.3g} [length], {:.3g} ulps", how_far, in_ulps(how_far, query.point)));
    return text;
}

}  // namespace type21
