#include <fmt/format.h>

#include "verification/performance/accuracy/accuracy_report.h"
#include "verification/support/build_info.h"

namespace type21::accuracy {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const TimingSpread& ns) {
    return {{"p50", ns.p50}, {"p95", ns.p95}, {"max", ns.max}, {"min", ns.min}};
}

Json json_of(const SceneRow& scene) {
    return {{"scene", scene.name},        {"kind", scene.kind},
            {"what", scene.what},         {"decisions", scene.decisions},
            {"contact", scene.contact},   {"proximity", scene.proximity},
            {"none", scene.none},         {"forces", scene.forced},
            {"segments", scene.segments}, {"candidates", scene.candidates}};
}

Json json_of(const ForceErrors& force) {
    Json json{{"judged", force.compared()}, {"spurious", force.spurious()}, {"not_finite", force.not_finite()}};
    if (force.compared() == force.not_finite()) return json;  // no number to give
    json["ulps_p99"] = force.ulps(0.99);
    json["ulps_max"] = force.ulps(1);
    json["relative_p99"] = force.relative(0.99);
    json["relative_max"] = force.relative(1);
    json["scaled_p99"] = force.scaled(0.99);
    json["scaled_max"] = force.scaled(1);
    return json;
}

Json json_of(const MethodRow& row) {
    return {{"scene", row.scene},
            {"kind", row.kind},
            {"group", row.group},
            {"method", row.method},
            {"implementation", row.implementation},
            {"what", row.what},
            {"exact", row.exact},
            {"ns", json_of(row.ns)},
            {"timed", row.timed},
            {"decisions", row.score.decisions},
            {"wrong", row.score.wrong},
            {"undecided", row.score.undecided},
            {"force", json_of(row.score.force)}};
}

Json json_of(const StageCountsRow& row) {
    Json stages = Json::array();
    for (const StageRow& stage : row.stages) {
        Json one{{"stage", stage.name}, {"settled", stage.settled}, {"timed", stage.timed}};
        if (stage.timed > 0) one["ns"] = json_of(stage.ns);
        stages.push_back(std::move(one));
    }
    return {{"scene", row.scene}, {"kind", row.kind}, {"implementation", row.implementation}, {"stages", stages}};
}

Json json_of(const EffectCost& cost) {
    return {{"effect", cost.effect},
            {"off_means", cost.off_means},
            {"implementation", cost.implementation},
            {"call", cost.lean ? "step_lean" : "step"},
            {"nodes", cost.nodes},
            {"cycles", cost.cycles},
            {"ns_absent", json_of(cost.absent)},
            {"ns_off", json_of(cost.off)},
            {"ns_on", json_of(cost.on)},
            {"extra_ns", cost.extra},
            {"off_ratio", cost.off_ratio},
            {"same_ratio", cost.same_ratio},
            {"off_error", cost.off_error},
            {"extra_error", cost.extra_error},
            {"same_program", cost.same_program},
            {"bytes_absent", cost.bytes_absent},
            {"bytes_off", cost.bytes_off},
            {"bytes_on", cost.bytes_on},
            {"acts", cost.changes_forces}};
}

template <class Rows>
Json all_of(const Rows& rows) {
    Json json = Json::array();
    for (const auto& row : rows)
        json.push_back(json_of(row));
    return json;
}

}  // namespace

Json to_json(const Result& result) {
    const BuildInfo& build = build_info();
    std::string command = "type21 accuracy";
    if (result.options.quick) command += " --quick";
    for (const std::string& scene : result.options.scenes)
        command += " --scene " + scene;
    return {{"format", 1},
            {"command", command},
            {"version", build.version},
            {"commit", build.commit},
            {"cpu", build.cpu},
            {"compiler", build.compiler},
            {"flags", build.flags},
            {"flags_optimized", TYPE21_FAST_FLAGS},
            {"build_type", build.build_type},
            {"clock", "processor time of the thread"},
            {"quick", result.options.quick},
            {"repeats", result.options.repeats_of_all()},
            {"seed", result.options.seed},
            {"stiffness", stiffness},
            {"seconds", result.seconds},
            {"exact_ones_are_right", result.exact_ones_are_right()},
            {"scenes", all_of(result.scenes)},
            {"rows", all_of(result.rows)},
            {"stage_counts", all_of(result.stage_counts)},
            {"effects", all_of(result.effects)}};
}

}  // namespace type21::accuracy
