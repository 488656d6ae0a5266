#include <fmt/format.h>

#include "verification/performance/bench/result.h"

namespace type21::bench {

namespace {

std::string shares(const std::vector<std::pair<std::string, double>>& all) {
    std::string out;
    for (const auto& [name, share] : all)
        out += fmt::format("{}{} {:.4g} %", out.empty() ? "" : ", ", name, 100 * share);
    return out;
}

std::string search_text(const std::vector<SearchRow>& rows) {
    if (rows.empty()) return {};
    std::string out =
        fmt::format("\n{:<16} {:<8} {:>7} {:>9} {:>9} {:>10} {:>11} {:>8} {:>11} {:>6} {:>7}\n", "search", "", "Bumult",
                    "margin", "ns", "ns a sort", "cycles/sort", "in all", "candidates", "boxes", "B/node");
    for (const SearchRow& s : rows) {
        out += s.bumult
                   ? fmt::format(
                         "{:<16} {:<8} {:>7g} {:>9.4g} {:>9.1f} {:>10.1f} {:>11.4g} {:>8.1f} {:>11.2f} "
                         "{:>6.2f} {:>7.0f}\n",
                         s.scene, s.search, *s.bumult, s.margin, s.ns, s.ns_sort, s.cycles_per_sort, s.ns_in_all,
                         s.candidates_per_node, s.boxes_per_node, s.bytes_per_node)
                   : fmt::format("{:<16} {:<8} {:>7} {:>9} {:>9.1f} {:>10} {:>11} {:>8.1f} {:>11} {:>6} {:>7.0f}\n",
                                 s.scene, s.search, "", "", s.ns, "", "", s.ns_in_all, "", "", s.bytes_per_node);
    }
    return out;
}

std::string scene_text(const BenchResult& result, const SceneRow& s) {
    std::string out = fmt::format("\n{}: {}\n  {} segments, {} nodes, {:.1f} % in contact; {} B per node\n", s.scene,
                                  s.title, s.segments, s.nodes, 100 * s.in_contact, s.bytes_per_node);
    for (const SetUp& one : s.setup)
        out += fmt::format("  set-up {:<34} {:>7.3f} s on {} {}{}\n", one.implementation, one.seconds, one.threads,
                           one.threads == 1 ? "thread" : "threads",
                           one.bytes == 0 ? "" : fmt::format(", {:.0f} B per segment", one.bytes_per_segment));
    if (!s.paths.empty())
        out += fmt::format("  coherent step  {}; first cycle {:.0f} ns\n", shares(s.paths), s.first_cycle);
    if (!s.stage_counts.empty()) out += fmt::format("  full search    {}\n", shares(s.stage_counts));
    out += fmt::format("  {:<50} {:>9} {:>9} {:>9} {:>9}  {:<18} {:>9} {:>7}\n", "ns per node and cycle", "median",
                       "p95", "max", "min", "finds", "decisions", "wrong");
    for (const MethodRow& row : result.rows) {
        if (row.scene != s.scene) continue;
        out += fmt::format("  {:<50} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f}  {:<18} {:>9} {:>7}{}\n",
                           row.implementation + ", " + row.method, row.ns.p50, row.ns.p95, row.ns.max, row.ns.min,
                           row.finds, row.decisions, row.wrong,
                           row.ulps_max ? fmt::format(", forces within {:.2f} ulps", *row.ulps_max) : "");
    }
    for (const RatioRow& row : result.ratios)
        if (row.scene == s.scene)
            out += fmt::format("  {:<70} {:>7.2f} x  (of minima {:.2f} x)\n", row.what, row.of_medians, row.of_minima);
    return out;
}

}  // namespace

std::string to_text(const BenchResult& result) {
    const MachineInfo& m = result.machine;
    std::string out = fmt::format("{}, {} processors, {}, FMA {:.1f} Gflop/s", m.cpu, m.processors, m.simd, m.fma);
    for (const Bandwidth& b : m.bandwidth)
        out += fmt::format("; {} {}: copy {:.1f}, triad {:.1f} GB/s", b.threads, b.threads == 1 ? "thread" : "threads",
                           b.copy, b.triad);
    out += fmt::format("; load {:.1f}\n", m.load_average);
    for (const SceneRow& scene : result.scenes)
        out += scene_text(result, scene);
    if (!result.stages.empty()) out += "\nstages of the coherent step\n";
    for (const StageRow& s : result.stages)
        out += fmt::format("  {:<8} {:<12} {:>8.2f} ns {:>6.1f} %  {}\n", s.scene, s.stage, s.ns, 100 * s.share, s.how);
    if (!result.effects.empty())
        out += fmt::format("\n{:<22} {:<10} {:>8} {:>8} {:>8}   on/off  off/absent\n", "effect", "call", "off", "on",
                           "absent");
    for (const EffectRow& e : result.effects)
        out += fmt::format("{:<22} {:<10} {:>8.1f} {:>8.1f} {:>8}   {:>6.3f}  {}\n", e.effect, e.call, e.ns_off,
                           e.ns_on, e.ns_absent ? fmt::format("{:.1f}", *e.ns_absent) : "-", e.ns_on / e.ns_off,
                           e.ns_absent ? fmt::format("{:.3f}", e.ns_off / *e.ns_absent) : "-");
    if (!result.growth.empty())
        out += fmt::format("\n{:<16} {:>9} {:>9} {:>10} {:>12} {:>8}\n", "growth", "segments", "nodes", "coherent",
                           "full search", "Embree");
    for (const GrowthRow& g : result.growth)
        out += fmt::format("{:<16} {:>9} {:>9} {:>10.1f} {:>12.1f} {:>8}\n", g.scene, g.segments, g.nodes, g.coherent,
                           g.full_search, g.embree ? fmt::format("{:.1f}", *g.embree) : "-");
    out += search_text(result.searches);
    if (!result.threads.empty()) out += "\n";
    for (const ThreadRow& t : result.threads)
        out += fmt::format("{}, {} {}: {:.1f} ns, {:.2f} x, {}\n", t.scene, t.threads,
                           t.threads == 1 ? "thread" : "threads", t.ns, t.speed_up,
                           t.same_bits ? "the same bits" : "OTHER BITS");
    if (result.roofline) {
        const Roofline& r = *result.roofline;
        out += fmt::format(
            "\n{}: {:.0f} B and {:.0f} flops a node: at least {:.1f} ns for memory, {:.1f} ns for arithmetic; "
            "the step takes {:.1f} ns, {:.1f} x\n",
            r.scene, r.bytes_per_node, r.flops_per_node, r.ns_bandwidth, r.ns_arithmetic, r.ns_step,
            r.ns_step / r.limit());
    }
    if (!result.check.empty()) out += "\n";
    for (const CheckPart& part : result.check)
        out += fmt::format("{:<60} {:>11} decisions, {} differ{}\n", part.what, part.decisions, part.different,
                           part.first_difference.empty() ? "" : "; first: " + part.first_difference);
    return out + to_text(result.targets);
}

}  // namespace type21::bench
