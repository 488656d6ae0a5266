#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "verification/performance/bench/result.h"
#include "verification/support/build_info.h"

namespace type21::bench {

namespace {

using Json = nlohmann::ordered_json;

Json of(const MachineInfo& m) {
    Json bandwidth = Json::array();
    for (const Bandwidth& b : m.bandwidth)
        bandwidth.push_back({{"threads", b.threads}, {"copy_gb_s", b.copy}, {"triad_gb_s", b.triad}});
    return {{"cpu", m.cpu},           {"processors", m.processors}, {"simd", m.simd},
            {"bandwidth", bandwidth}, {"fma_gflop_s", m.fma},       {"load_average", m.load_average}};
}

Json shares(const std::vector<std::pair<std::string, double>>& all) {
    Json out = Json::object();
    for (const auto& [name, share] : all)
        out[name] = share;
    return out;
}

Json of(const SceneRow& s) {
    Json setup = Json::array();
    for (const SetUp& one : s.setup) {
        setup.push_back({{"implementation", one.implementation}, {"threads", one.threads}, {"seconds", one.seconds}});
        if (one.bytes == 0) continue;
        setup.back()["bytes"] = one.bytes;
        setup.back()["bytes_per_segment"] = one.bytes_per_segment;
    }
    Json out{{"scene", s.scene},
             {"title", s.title},
             {"kind", s.kind},
             {"segments", s.segments},
             {"sub_triangles", s.sub_triangles},
             {"nodes", s.nodes},
             {"gap", s.gap},
             {"depth", s.depth},
             {"step", s.step},
             {"in_contact", s.in_contact},
             {"repeats", s.repeats},
             {"setup", setup},
             {"bytes_per_node", s.bytes_per_node},
             {"first_cycle", s.first_cycle}};
    if (!s.paths.empty()) out["paths"] = shares(s.paths);
    if (!s.stage_counts.empty()) out["stage_counts"] = shares(s.stage_counts);
    return out;
}

Json of(const MethodRow& r) {
    Json out{{"scene", r.scene},
             {"kind", r.kind},
             {"implementation", r.implementation},
             {"method", r.method},
             {"finds", r.finds},
             {"history", r.history},
             {"threads", r.threads},
             {"ns", {{"p50", r.ns.p50}, {"p95", r.ns.p95}, {"max", r.ns.max}, {"min", r.ns.min}}},
             {"decisions", r.decisions},
             {"wrong", r.wrong}};
    if (r.ulps_max) out["force"] = {{"ulps_max", *r.ulps_max}};
    if (!r.note.empty()) out["note"] = r.note;
    return out;
}

Json of(const RatioRow& r) {
    return {{"scene", r.scene},           {"what", r.what},          {"slow", r.slow}, {"fast", r.fast},
            {"of_medians", r.of_medians}, {"of_minima", r.of_minima}};
}
Json of(const StageRow& s) {
    return {{"scene", s.scene}, {"stage", s.stage}, {"ns", s.ns}, {"share", s.share}, {"how", s.how}};
}
Json of(const EffectRow& e) {
    Json out{{"effect", e.effect}, {"call", e.call}, {"ns_off", e.ns_off}, {"ns_on", e.ns_on}};
    if (e.ns_absent) out["ns_absent"] = *e.ns_absent;
    return out;
}
Json of(const GrowthRow& g) {
    Json out{{"scene", g.scene},
             {"segments", g.segments},
             {"nodes", g.nodes},
             {"coherent", g.coherent},
             {"full_search", g.full_search}};
    if (g.embree) out["embree"] = *g.embree;
    return out;
}
Json of(const SearchRow& s) {
    Json out{{"scene", s.scene}, {"search", s.search}};
    if (s.bumult)
        out.update({{"bumult", *s.bumult},
                    {"margin", s.margin},
                    {"ns_sort", s.ns_sort},
                    {"cycles_per_sort", s.cycles_per_sort},
                    {"candidates_per_node", s.candidates_per_node},
                    {"boxes_per_node", s.boxes_per_node}});
    out.update({{"ns", s.ns},
                {"ns_in_all", s.ns_in_all},
                {"bytes_per_node", s.bytes_per_node},
                {"bytes_per_segment", s.bytes_per_segment}});
    return out;
}
Json of(const ThreadRow& t) {
    return {
        {"scene", t.scene}, {"threads", t.threads}, {"ns", t.ns}, {"speed_up", t.speed_up}, {"same_bits", t.same_bits}};
}
Json of(const Roofline& r) {
    return {{"scene", r.scene},
            {"bytes_per_node", r.bytes_per_node},
            {"flops_per_node", r.flops_per_node},
            {"ns_bandwidth", r.ns_bandwidth},
            {"ns_arithmetic", r.ns_arithmetic},
            {"ns_limit", r.limit()},
            {"ns_step", r.ns_step},
            {"times_the_limit", r.ns_step / r.limit()}};
}
Json of(const Target& t) {
    Json out{{"target", t.target},     {"scene", t.scene},
             {"unit", t.unit},         {"better", t.better == Better::higher ? "higher" : "lower"},
             {"at_least", t.at_least}, {"aim", t.aim},
             {"measured", t.measured}, {"reached", t.reached()}};
    if (!t.note.empty()) out["note"] = t.note;
    return out;
}

template <class Row>
Json all(const std::vector<Row>& rows) {
    Json out = Json::array();
    for (const Row& row : rows)
        out.push_back(of(row));
    return out;
}

void refuse_what_is_no_number(const Json& json, const std::string& place) {
    if (json.is_number_float() && !std::isfinite(json.get<double>()))
        throw std::runtime_error("bench: " + place + " is not a finite number");
    if (json.is_object())
        for (const auto& [key, value] : json.items())
            refuse_what_is_no_number(value, place + "/" + key);
    if (json.is_array())
        for (size_t i = 0; i < json.size(); ++i)
            refuse_what_is_no_number(json[i], fmt::format("{}/{}", place, i));
}

}  // namespace

long BenchResult::decisions() const {
    long sum = 0;
    for (const CheckPart& part : check)
        sum += part.decisions;
    return sum;
}

long BenchResult::different() const {
    long sum = 0;
    for (const CheckPart& part : check)
        sum += part.different;
    return sum;
}

Json to_json(const BenchResult& result) {
    const BuildInfo& build = build_info();
    Json parts = Json::array();
    std::string first;
    for (const CheckPart& part : result.check) {
        parts.push_back({{"what", part.what}, {"decisions", part.decisions}, {"different", part.different}});
        if (first.empty()) first = part.first_difference;
    }
    Json out{{"format", 1},
             {"command", result.command},
             {"version", build.version},
             {"commit", build.commit},
             {"cpu", result.machine.cpu},
             {"compiler", build.compiler},
             {"flags", build.flags + "; optimized and bench: -O3 -fno-math-errno -fno-trapping-math"},
             {"repeats", result.repeats},
             {"quick", result.quick},
             {"seconds", result.seconds},
             {"machine", of(result.machine)},
             {"scenes", all(result.scenes)},
             {"rows", all(result.rows)},
             {"ratios", all(result.ratios)},
             {"stages", all(result.stages)},
             {"effects", all(result.effects)},
             {"growth", all(result.growth)},
             {"searches", all(result.searches)},
             {"threads", all(result.threads)},
             {"check",
              {{"decisions", result.decisions()},
               {"different", result.different()},
               {"first_difference", first},
               {"parts", parts}}},
             {"targets", all(result.targets)}};
    if (result.roofline) out["roofline"] = of(*result.roofline);
    refuse_what_is_no_number(out, "");
    return out;
}

}  // namespace type21::bench
