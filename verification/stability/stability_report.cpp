#include "verification/stability/stability_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace type21::stability {

std::string to_text(const LongRun& run) {
    std::string text = fmt::format("{}: {}\n  {}\n  {} cycles\n", run.name, run.holds() ? "holds" : "DOES NOT HOLD",
                                   run.statement, run.cycles);
    for (const Finding& finding : run.findings) {
        const char* verdict = !finding.asked() ? "shown" : finding.holds() ? "holds" : "FAILS";
        text += fmt::format("  {:<5}  {:>13.6g} {:<4}  {}\n", verdict, finding.value, finding.unit, finding.what);
        text += fmt::format("         {:>18}  ", "");
        if (finding.asked()) text += fmt::format("in [{:.3g}, {:.3g}]: ", finding.at_least, finding.at_most);
        text += finding.expected + "\n";
    }
    return text;
}

std::string to_text(const std::vector<SlidingRow>& rows) {
    std::string text = fmt::format(
        "sliding: largest jump of the force between neighbouring cycles [N], k = 1000 N/mm, penetration {} mm, "
        "friction {}\n"
        "  a way of {} mm a cycle, halved four times; residual: what does not halve\n\n"
        "  {:<8} {:<10} {:<10}",
        path_depth, path_friction, first_step, "tool", "mesh", "");
    for (int i = 0; i < path_steps; ++i)
        text += fmt::format(" {:>9}", fmt::format("h/{}", 1 << i));
    text += fmt::format(" {:>9} {:>9}  {}\n", "residual", "facets'", "verdict");
    for (const SlidingRow& row : rows) {
        const auto line = [&](const char* what, const Jumps& jumps, const Jumps& facets, const char* verdict) {
            text += fmt::format("  {:<8} {:<10} {:<10}", name(row.shape), name(row.mesh), what);
            for (const double jump : jumps.largest)
                text += fmt::format(" {:>9.2e}", jump);
            text += fmt::format(" {:>9.2e} {:>9.2e}  {}\n", jumps.residual(), facets.residual(), verdict);
        };
        line("normal", row.normal, row.facet_normal, holds(row) ? "holds" : "FAILS");
        line("friction", row.friction, row.facet_friction, "");
    }
    return text +
           "\n  facets': the residual with the plain normal of the nearest facet on the same path.\n"
           "  The interpolated normal goes through every edge without a jump where the walls between the lifted "
           "sub-triangles\n"
           "  are plane: flat tools, and cylinders with edges along or across the axis. On distorted and warped meshes "
           "the\n"
           "  normals at the two ends of an edge are not in one plane with it. The sub-triangles at its sides then "
           "lift the\n"
           "  edge to two slightly different lines, and the choice between them (the smaller kappa) goes from one to "
           "the\n"
           "  other a little beside both: the weights, the normal and the distance jump by what lies between. It is "
           "the\n"
           "  method's own discontinuity: of second order in the angle between the facets, and no step makes it "
           "smaller.\n";
}

nlohmann::ordered_json to_json(const LongRun& run) {
    nlohmann::ordered_json findings = nlohmann::ordered_json::array();
    const auto bound = [](double value) {
        return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
    };
    for (const Finding& finding : run.findings)
        findings.push_back({{"what", finding.what},
                            {"value", bound(finding.value)},
                            {"unit", finding.unit},
                            {"at_least", bound(finding.at_least)},
                            {"at_most", bound(finding.at_most)},
                            {"expected", finding.expected},
                            {"asked", finding.asked()},
                            {"holds", finding.holds()}});
    return {{"name", run.name},
            {"statement", run.statement},
            {"cycles", run.cycles},
            {"holds", run.holds()},
            {"findings", findings}};
}

nlohmann::ordered_json to_json(const std::vector<SlidingRow>& rows) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    const auto jumps_json = [](const Jumps& jumps) {
        return nlohmann::ordered_json{{"largest_jump", jumps.largest}, {"residual", jumps.residual()}};
    };
    for (const SlidingRow& row : rows)
        out.push_back({{"tool", name(row.shape)},
                       {"mesh", name(row.mesh)},
                       {"unit", "N"},
                       {"first_step_mm", first_step},
                       {"mean_normal_force", row.mean_force},
                       {"cycles_out_of_contact", row.open},
                       {"normal", jumps_json(row.normal)},
                       {"friction", jumps_json(row.friction)},
                       {"facet_normal", jumps_json(row.facet_normal)},
                       {"facet_friction", jumps_json(row.facet_friction)},
                       {"residual_bound", residual_bound(row)},
                       {"holds", holds(row)}});
    return out;
}

double residual_bound(const SlidingRow& row) {
    // Rounding of k times a position of some 10 mm, a few operations long.
    constexpr double rounding = 1e-11;
    const bool ruled = row.mesh == Mesh::quad || row.mesh == Mesh::triangle;
    if (row.shape == Shape::flat && row.mesh != Mesh::warped) return rounding;
    // Smooth force on the ruled meshes: the curve of J(h) leaves O(h^2), measured 1.6e-4 N at 60 N of the facets.
    // Distorted and warped: second order in the angle between the facets; measured 0.0016 and 0.014 to 0.043 of the
    // facets'.
    const double share = ruled ? 1e-4 : row.mesh == Mesh::distorted ? 0.005 : 0.1;
    return share * row.facet_normal.residual();
}

bool holds(const SlidingRow& row) {
    return row.open == 0 && row.normal.residual() <= residual_bound(row) &&
           row.friction.residual() <=
               std::max(1e-11, row.facet_friction.residual() * (row.mesh == Mesh::warped ? 0.1 : 0.005));
}

}  // namespace type21::stability
