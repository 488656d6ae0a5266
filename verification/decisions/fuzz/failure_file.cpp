#include "verification/decisions/fuzz/failure_file.h"

#include <functional>
#include <optional>

#include <fmt/format.h>

#include "reference/exact/impact_enclosure.h"
#include "verification/decisions/fuzz/judgement.h"
#include "verification/decisions/fuzz/second_opinion.h"
#include "verification/decisions/queries/decision_json.h"
#include "verification/decisions/queries/decision_text.h"
#include "verification/decisions/queries/question.h"

namespace type21 {

namespace {

using JudgePiece = std::function<std::optional<reference::ImpactEnclosure>(const reference::SegmentShape<double>& shape,
                                                                           int segment, int k)>;

/// The race among pieces judged by one arithmetic; nothing where it cannot tell.
std::optional<DecisionAnswer> race(const Question& question, const JudgePiece& judge_piece) {
    reference::ImpactEnclosure best;
    for (const int segment : question.segments()) {
        const auto shape = question.input().shape_of(segment);
        for (int k = 1; k <= shape.sub_triangles(); ++k) {
            const auto one = judge_piece(shape, segment, k);
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
    const auto fails = [&](const SingleQuestion& question) {
        return !judge(question.tool, question.query, options.method, Scrutiny::full).wrong.empty();
    };
    const SingleQuestion small = shrink({failure.tool, failure.question}, fails);
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
    json["found"] = {{"family", family}, {"seed", options.seed}, {"block", failure.block}, {"query", failure.query}};
    return json;
}

std::string every_answer(const DecisionTool& tool, const DecisionQuery& query) {
    const Question question(tool, query);
    const reference::DecisionInput& input = question.input();
    const auto by_bound = [&](const auto& shape, int segment, int k) {
        return reference::judged_by_bound(input, shape, segment, k);
    };
    const auto by_interval = [&](const auto& shape, int segment, int k) {
        return reference::judged_by_interval(input, shape, segment, k);
    };
    const DecisionAnswer staged = decide(tool, query, DecideWith::reference);
    std::string text;
    const auto line = [&](const char* how, const std::string& answer) {
        text += fmt::format("  {:<20} {}\n", how, answer);
    };
    line("plain double", in_words(decide(tool, query, DecideWith::plain)));
    line("double with a bound", in_words(race(question, by_bound)));
    line("interval", in_words(race(question, by_interval)));
    line("rational numbers", in_words(decide(tool, query, DecideWith::exact)));
    line("reference", fmt::format("{}; settled by {}", in_words(staged), name(staged.stage)));
    line("optimized", in_words(decide(tool, query, DecideWith::optimized)));
    line("second opinion", in_words(second_opinion(tool, query)));
    const double how_far = margin(tool, query);
    line("margin", fmt::format("{:.3g} [length], {:.3g} ulps", how_far, in_ulps(how_far, query.point)));
    return text;
}

}  // namespace type21
