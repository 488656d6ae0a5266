#include "verification/stability/stability_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace type21::stability {

std::string to_text(const LongRun& run) {
    std::string text = fmt::format("{}: {}\n  {}\n  {} cycles\n", run.name, run.holds() ? "holds" : "DOES NOT HOLD",
                                   run.statement, run.cycles);
    for (const Finding& finding : run.findings) {
        const char* verdict = !finding.has_bound() ? "shown" : finding.holds() ? "holds" : "FAILS";
        text += fmt::format("  {:<5}  {:>13.6g} {:<4}  {}\n", verdict, finding.value, finding.unit, finding.what);
        text += fmt::format("         {:>18}  ", "");
        if (finding.has_bound()) text += fmt::format("in [{:.3g}, {:.3g}]: ", finding.at_least, finding.at_most);
        text += finding.expected + "\n";
    }
    return text;
}

std::string to_text(const std::vector<SlidingRow>& rows) {
    std::string text = fmt::format(
        "sliding: largest jump of the force between neighbouring cycles [N], k = 1000 N/mm, penetration {} mm, "
        "friction {}\n"
        "  h = {} mm travel in a cycle, halved four times; residual: the part that does not halve\n\n"
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
           "  Across a common edge the interpolated normal and the distance are continuous (to second order in the "
           "angle of the\n"
           "  fold times the height), so a jump has another cause: the choice of the sub-triangle. A sub-triangle "
           "takes "
           "a node\n"
           "  up to 1 % outside of it, and of all that take it the one with the smallest kappa is retained. Where two "
           "weights\n"
           "  are below 1/3, kappa is 2 (largest weight - 1/3) and does not depend on which side of the edge the node "
           "is.\n"
           "  On flat tools and on cylinders of quads along the axis both sides have the same kappa, or lie in one "
           "plane. On\n"
           "  distorted quads one side has the smaller kappa over the whole strip of 1 %: the node follows the "
           "extended "
           "facet\n"
           "  of a neighbour and changes to the other one at the end of the strip. The jump is of the order k x 1 % of "
           "the\n"
           "  element x angle of the fold, and no smaller step reduces it. It is a property of the method.\n";
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
                            {"has_bound", finding.has_bound()},
                            {"holds", finding.holds()}});
    return {{"name", run.name},
            {"statement", run.statement},
            {"cycles", run.cycles},
            {"holds", run.holds()},
            {"findings", findings}};
}

nlohmann::ordered_json to_json(const std::vector<SlidingRow>& rows) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    const auto jumps = [](const Jumps& of) {
        return nlohmann::ordered_json{{"largest_jump", of.largest}, {"residual", of.residual()}};
    };
    for (const SlidingRow& row : rows)
        out.push_back({{"tool", name(row.shape)},
                       {"mesh", name(row.mesh)},
                       {"unit", "N"},
                       {"first_step_mm", first_step},
                       {"mean_normal_force", row.mean_force},
                       {"cycles_out_of_contact", row.open},
                       {"normal", jumps(row.normal)},
                       {"friction", jumps(row.friction)},
                       {"facet_normal", jumps(row.facet_normal)},
                       {"facet_friction", jumps(row.facet_friction)},
                       {"residual_bound",
                        {{"normal", residual_bound(row, row.facet_normal)},
                         {"friction", residual_bound(row, row.facet_friction)}}},
                       {"holds", holds(row)}});
    return out;
}

double residual_bound(const SlidingRow& row, const Jumps& facets) {
    // Rounding of k times a position of some 10 mm: 1e4 N x 1e-16, a few operations long.
    constexpr double rounding = 1e-11;
    if (row.shape == Shape::flat && row.mesh != Mesh::warped) return rounding;
    // Smooth where quads lie along the axis: the curve of J(h) leaves O(h^2); measured 2.6e-6 of the facets' jump.
    // Distorted and warped: k x 1 % of the element x angle of the fold against k p x angle, 0.01 x 1 mm / 0.3 mm = 0.03
    // for the folds themselves; measured up to 0.0017 (distorted) and 0.047 (warped, which has folds inside each quad).
    const double share = row.mesh == Mesh::warped ? 0.1 : row.mesh == Mesh::distorted ? 0.005 : 1e-4;
    return share * facets.residual();
}

bool holds(const SlidingRow& row) {
    return row.open == 0 && row.normal.residual() <= residual_bound(row, row.facet_normal) &&
           row.friction.residual() <= residual_bound(row, row.facet_friction);
}

}  // namespace type21::stability
