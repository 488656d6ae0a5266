#include <fmt/format.h>

#include "verification/performance/accuracy/accuracy_report.h"

namespace type21::accuracy {

namespace {

std::string table_of(const SceneRow& scene, const Result& result) {
    std::string text = fmt::format(
        "{} ({}): {}\n  {} decisions: {} contact, {} proximity, {} none; {} forces; {:.3g} candidates each\n",
        scene.name, scene.kind, scene.what, scene.decisions, scene.contact, scene.proximity, scene.none, scene.forced,
        scene.candidates);
    text += fmt::format("  {:<38} {:>9} {:>9} {:>9} {:>8} {:>6} {:>9} {:>10} {:>10} {:>9} {:>9}\n", "", "ns p50", "p95",
                        "max", "judged", "wrong", "undecided", "99 % ulps", "max ulps", "max rel.", "scaled");
    std::string group;
    for (const MethodRow& row : result.rows) {
        if (row.scene != scene.name) continue;
        if (row.group != group)
            text += row.group == "search" ? "  with the search for candidates\n" : "  candidates given\n";
        group = row.group;
        const Score& score = row.score;
        text += fmt::format(
            "    {:<36} {:>9.4g} {:>9.4g} {:>9.4g} {:>8} {:>6} {:>9} {:>10.3g} {:>10.3g} {:>9.2g} {:>9.2g}{}\n",
            row.implementation.empty() ? row.method : row.implementation + ", " + row.method, row.ns.p50, row.ns.p95,
            row.ns.max, score.decisions, score.wrong, score.undecided, score.force.ulps(0.99), score.force.ulps(1),
            score.force.relative(1), score.force.scaled(1),
            row.exact && score.wrong > 0 ? "  WRONG, and must not be" : "");
    }
    return text;
}

std::string text_of(const StageCountsRow& row) {
    size_t all = 0;
    for (const StageRow& stage : row.stages)
        all += stage.settled;
    std::string text = fmt::format("  {} settles", row.implementation);
    const char* mark = " ";
    for (const StageRow& stage : row.stages) {
        if (stage.settled == 0) continue;
        text += fmt::format("{}{:.3g} % by {} ({:.4g} ns)", mark,
                            100.0 * static_cast<double>(stage.settled) / static_cast<double>(all), stage.name,
                            stage.ns.p50);
        mark = ", ";
    }
    return text + "\n";
}

std::string effects_of(const Result& result) {
    if (result.effects.empty()) return {};
    std::string text = fmt::format(
        "effects: ns per node and cycle of a whole contact cycle\n  {:<42} {:<10} {:>8} {:>8} {:>8} {:>8} {:>12}\n", "",
        "", "without", "off", "on", "extra", "off/without");
    for (const EffectCost& cost : result.effects)
        text += fmt::format("  {:<42} {:<10} {:>8.4g} {:>8.4g} {:>8.4g} {:>8.3g} {:>6.3f} +-{:.3f}{}{}\n", cost.effect,
                            cost.implementation, cost.absent.p50, cost.off.p50, cost.on.p50, cost.extra, cost.off_ratio,
                            cost.off_error, cost.same_program ? "" : "  STILL PLANNED WHEN OFF",
                            cost.bytes_off == cost.bytes_absent ? "" : "  HOLDS MEMORY WHEN OFF");
    return text + "  extra: median of on - off, cycle by cycle; +-: standard error of the ratio\n";
}

}  // namespace

std::string to_text(const Result& result) {
    std::string text;
    for (const SceneRow& scene : result.scenes) {
        text += table_of(scene, result);
        for (const StageCountsRow& row : result.stage_counts)
            if (row.scene == scene.name) text += text_of(row);
        text += "\n";
    }
    text += effects_of(result);
    size_t wrong = 0;
    for (const MethodRow& row : result.rows)
        wrong += row.exact ? row.score.wrong : 0;
    return text + fmt::format("{} repeats, {:.1f} s; methods that promise exact decisions: {} wrong\n",
                              result.options.repeats_of_all(), result.seconds, wrong);
}

}  // namespace type21::accuracy
