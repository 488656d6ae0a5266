#include "verification/cli/run_output.h"

#include <fmt/format.h>

#include "verification/decisions/queries/decision_text.h"

namespace type21::cli {
namespace {

std::string vector_text(const Vec3& v) {
    return fmt::format("{:>14.6e} {:>14.6e} {:>14.6e}", v.x(), v.y(), v.z());
}

std::string interface_text(const RunSummary& summary, const Model& model, size_t i) {
    const ContactCount& count = summary.contact[i];
    const InterfaceBalance& balance = summary.balance[i];
    const InterfaceTotals& totals = summary.totals[i];
    const UnitSystem& units = model.units;
    const std::string impulse = units.name({1, 1, -1, 0});
    const std::string energy = units.name(dim::energy);
    std::string out = fmt::format("\ninterface {} '{}'\n", model.interfaces[i].id, model.interfaces[i].title);
    out += fmt::format("  contact   {} of {} nodes at the end ({} stick, {} slide), at most {}, in {} cycles\n",
                       count.in_contact, count.nodes, count.sticking, count.sliding, count.most_in_contact,
                       count.cycles_in_contact);
    if (count.deepest_node >= 0)
        out += fmt::format("  deepest   {:.6g} {} at node {}, time {:.6g} {}\n", count.deepest, units.name(dim::length),
                           model.nodes.id[static_cast<size_t>(count.deepest_node)], count.deepest_time,
                           units.name(dim::time));
    if (const std::string decisions = to_text(summary.stage_counts[i]); !decisions.empty()) out += "  " + decisions;
    if (const auto& sorted = summary.sorted_search[i])
        out += fmt::format(
            "  search    margin {:.4g} {} (Bumult {:g}), sorted in {} of {} cycles, {:.2f} candidates a node, of which "
            "{:.2f} had it in their box, {:.0f} bytes a node\n",
            sorted->margin, units.name(dim::length), model.interfaces[i].bumult.value, sorted->sorts, sorted->cycles,
            sorted->candidates_per_node(), sorted->near_per_node(),
            static_cast<double>(sorted->bytes) / std::max(1, model.interfaces[i].secondary.size()));
    out += fmt::format("  impulse on the tool, normal      {} {}\n", vector_text(totals.normal), impulse);
    out += fmt::format("                       tangential  {} {}\n", vector_text(totals.tangential), impulse);
    out +=
        fmt::format("  energy    elastic {:.6e}, friction {:.6e}, damping {:.6e}, friction heat {:.6e} {}\n",
                    totals.elastic_energy, totals.friction_energy, totals.damping_energy, totals.friction_heat, energy);
    out += fmt::format("  balance   force {:.1e}, power {:.1e}, CE_DAMP {:.1e}, CE_FRIC {:.1e} of the absolute terms\n",
                       balance.force.relative, balance.power.relative, balance.damping_energy.relative,
                       balance.friction_energy.relative);
    return out;
}

}  // namespace

std::string run_text(const RunSummary& summary, const HostScene& scene, const std::string& folder) {
    const Model& model = *scene.host;
    const std::string time = model.units.name(dim::time);
    std::string out = fmt::format("{}: {} cycles to time {:.9g} {}, steps {:.4g} to {:.4g} {}, {:.2f} s of wall time\n",
                                  name(summary.state), summary.cycles, summary.time, time, summary.smallest_step,
                                  summary.largest_step, time, summary.wall_seconds);
    for (size_t i = 0; i < summary.totals.size(); ++i)
        out += interface_text(summary, model, i);
    return out + fmt::format("\nresults in {}\n", folder);
}

}  // namespace type21::cli
