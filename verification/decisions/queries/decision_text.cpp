#include "verification/decisions/queries/decision_text.h"

#include <fmt/format.h>

namespace type21 {

namespace {

double per_decision(double seconds, long count) {
    return count == 0 ? 0 : 1e9 * seconds / static_cast<double>(count);
}

}  // namespace

std::string in_words(const DecisionAnswer& answer) {
    if (answer.kind == Kind::none) return "none";
    return fmt::format("{} with segment {}, triangle {}, side {:+}", name(answer.kind), answer.segment, answer.triangle,
                       answer.side);
}

DecisionTally answer_all(DecisionFile& file, DecideWith method) {
    DecisionTally tally;
    for (size_t b = 0; b < file.blocks.size(); ++b) {
        DecisionBlock& block = file.blocks[b];
        std::vector<DecisionAnswer> answers;
        answers.reserve(block.queries.size());
        for (const ContactQuery& query : block.queries) {
            DecisionAnswer answer = decide(block.tool, query, method, &tally.stage_counts);
            answer.margin = margin(block.tool, query);
            answer.margin_ulps = in_ulps(answer.margin, query.point);
            ++tally.queries;
            if (answer.kind == Kind::contact) ++tally.contact;
            if (answer.kind == Kind::proximity) ++tally.proximity;
            if (answer.margin_ulps < near_border_ulps) ++tally.near_border;
            if (!block.answers.empty()) {
                const DecisionAnswer& expected = block.answers[answers.size()];
                ++tally.compared;
                if (!answer.same_decision(expected))
                    tally.different.push_back(fmt::format("block {}, query {}: {}; the file says {}", b, answers.size(),
                                                          in_words(answer), in_words(expected)));
            }
            answers.push_back(answer);
        }
        block.answers = std::move(answers);
    }
    return tally;
}

std::string to_text(const DecisionStageCounts& counts) {
    const long decided = counts.decisions() - counts.nothing_near;
    if (decided == 0) return {};
    const auto share = [&](size_t stage) {
        return 100.0 * static_cast<double>(counts.settled[stage]) / static_cast<double>(decided);
    };
    // A stage is entered by all that the stages before it left open.
    const long exact = counts.settled[2];
    const long interval = exact + counts.settled[1];
    std::string text = fmt::format("decisions {}: {:.4g} % settled by double, {:.4g} % by interval, {:.4g} % exactly",
                                   decided, share(0), share(1), share(2));
    // The optimized contact takes no times and does not ask what plain double would have decided.
    if (counts.seconds[0] > 0)
        text += fmt::format(
            "; plain double would have been wrong in {}; {:.0f}, {:.0f}, {:.0f} ns per decision that entered the stage",
            counts.double_wrong, per_decision(counts.seconds[0], decided), per_decision(counts.seconds[1], interval),
            per_decision(counts.seconds[2], exact));
    return text + "\n";
}

std::string to_text(const DecisionTally& tally) {
    std::string text =
        fmt::format("{} queries: {} contact, {} proximity, {} none; {} within {:.0e} ulps of another answer\n",
                    tally.queries, tally.contact, tally.proximity, tally.queries - tally.contact - tally.proximity,
                    tally.near_border, near_border_ulps);
    text += to_text(tally.stage_counts);
    if (tally.compared > 0)
        text += fmt::format("{} answers of the file compared: {} differ\n", tally.compared, tally.different.size());
    for (size_t i = 0; i < tally.different.size() && i < 20; ++i)
        text += "  " + tally.different[i] + "\n";
    if (tally.different.size() > 20) text += fmt::format("  and {} more\n", tally.different.size() - 20);
    return text;
}

nlohmann::ordered_json to_json(const DecisionStageCounts& counts) {
    nlohmann::ordered_json json;
    json["nothing_near"] = counts.nothing_near;
    json["settled"] = {{"double", counts.settled[0]}, {"interval", counts.settled[1]}, {"exact", counts.settled[2]}};
    json["double_wrong"] = counts.double_wrong;
    json["seconds"] = {{"double", counts.seconds[0]}, {"interval", counts.seconds[1]}, {"exact", counts.seconds[2]}};
    return json;
}

}  // namespace type21
