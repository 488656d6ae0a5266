/// @file Gaps of time 0.
#include "reference/model/nodal_gaps.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/sourced_rules.h"

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

bool is_void(const Model& model, const Shell& shell) {
    const int material = model.parts[at(shell.part)].material;
    return material < 0 || model.materials[at(material)].law == MaterialLaw::none;
}

std::vector<double> picked(const std::vector<double>& of_all_nodes, const std::vector<int>& nodes) {
    std::vector<double> values(nodes.size());
    std::transform(nodes.begin(), nodes.end(), values.begin(), [&](int node) { return of_all_nodes[at(node)]; });
    return values;
}

/// Unweighted mean thickness of the shells of the secondary surface, void ones too; 0 without any.
double mean_shell_thickness(const CardValidator& validator) {
    const Surface& surface = validator.model.surfaces[at(validator.interface.secondary_surface)];
    std::vector<double> thickness;
    for (size_t rank = 0; rank < surface.segments.size(); ++rank) {
        const int shell = surface.segments[rank].shell;
        if (shell >= 0 && !surface.is_repeated(static_cast<int>(rank)))
            thickness.push_back(validator.model.shells[at(shell)].thickness);
    }
    return mean(thickness);
}

/// Gapmin of Igap 0; half of a mean thickness if it is not given.
/// @manual field Gapmin; comment 2
void resolve_constant_gap(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.gapmin != 0) return;
    const GapminDefault fallback = validator.reading().gapmin_default(validator);
    take_default(it.gapmin, fallback.value, fallback.why);
    if (it.gapmin == 0)
        validator.warning(
            "Gapmin",
            "Igap 0 without Gapmin takes half of the mean thickness of the secondary shells, and they have "
            "none: the gap is 0",
            "Give Gapmin");
}

/// The search reaches farther than one element. What DEPTH is raised to, the largest gap, is the cause as soon as it is
/// longer than the edge itself: a smaller DEPTH would then change nothing.
void warn_of_wide_search(const CardValidator& validator) {
    const Interface& it = validator.interface;
    const std::string edge = validator.length(it.shortest_edge);
    if (it.largest_gap <= it.shortest_edge) {
        validator.warning(
            "DEPTH",
            fmt::format("is larger than the shortest secondary edge {}: more of the mesh is searched than one element",
                        edge),
            "Give a smaller DEPTH unless nodes really get that deep");
        return;
    }
    const std::string rule = fmt::format(
        "makes the largest gap {}, which is longer than the shortest secondary edge {}: more of the mesh is searched "
        "than one element, whatever DEPTH is",
        validator.length(it.largest_gap), edge);
    if (it.igap == 0 || it.gapmin >= it.largest_gap) {
        validator.warning("Gapmin", rule, "Give a smaller Gapmin, or a coarser blank");
        return;
    }
    const bool scaled = it.fscalegap > 1;
    validator.warning(scaled ? "Fscalegap" : "Igap",
                      scaled ? rule : "takes the gap from the thickness of the blank: it " + rule,
                      "Give a Gapmax below the edge, or a coarser blank");
}

/// @manual field DEPTH; comment 4
void resolve_depth(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.depth == 0) {
        take_default(it.depth, std::max(it.largest_gap, it.shortest_edge),
                     "0 means the larger of the largest gap and the shortest secondary edge");
    } else if (it.depth < it.largest_gap) {
        take_by_rule(it.depth, it.largest_gap, fmt::format("raised from {} to the largest gap", it.depth.value));
    }
    if (it.depth > it.shortest_edge) warn_of_wide_search(validator);
}

}  // namespace

double part_thickness(const Model& model, const Segment& segment) {
    return segment.shell < 0 ? 0.0 : model.parts[at(model.shells[at(segment.shell)].part)].contact_thickness;
}

double mean(const std::vector<double>& values) {
    double mean_so_far = 0;
    double count = 0;
    for (const double value : values)
        mean_so_far += (value - mean_so_far) / ++count;
    return mean_so_far;
}

GapminDefault gapmin_default(const CardValidator& validator) {
    return {0.5 * mean_shell_thickness(validator), "half of the mean thickness of the secondary shells"};
}

double own_search_gap(const Interface& /*interface*/, double /*raw*/, double gap) {
    return gap;
}

std::vector<double> nodal_thickness(const Model& model, const std::vector<int>& nodes) {
    std::vector<double> largest(model.nodes.id.size(), 0.0);
    for (const Shell& shell : model.shells) {
        if (shell.part < 0 || is_void(model, shell)) continue;
        for (const int node : shell.node)
            largest[at(node)] = std::max(largest[at(node)], shell.thickness);
    }
    return picked(largest, nodes);
}

std::vector<bool> nodes_of_void_shells(const Model& model) {
    std::vector<bool> with_void(model.nodes.id.size(), false);
    std::vector<bool> with_other(model.nodes.id.size(), false);
    for (const Shell& shell : model.shells) {
        auto& nodes = shell.part < 0 || is_void(model, shell) ? with_void : with_other;
        for (const int node : shell.node)
            nodes[at(node)] = true;
    }
    for (size_t i = 0; i < with_void.size(); ++i)
        with_void[i] = with_void[i] && !with_other[i];
    return with_void;
}

/// @manual eq 3, 4
std::vector<double> contact_thickness(const Model& model, const Surface& secondary, const std::vector<int>& nodes) {
    std::vector<double> largest(model.nodes.id.size(), 0.0);
    for (const Segment& segment : secondary.segments)
        for (const int node : segment.node)
            largest[at(node)] = std::max(largest[at(node)], part_thickness(model, segment));
    return picked(largest, nodes);
}

/// @manual eq 1-4; field Igap, Fscalegap, Gapmin, Gapmax; comment 2
void resolve_gaps(const CardValidator& validator) {
    Interface& it = validator.interface;
    SecondarySide& side = it.secondary;
    const auto count = at(side.size());
    if (it.igap == 0) {
        resolve_constant_gap(validator);
        side.gap.assign(count, it.gapmin);
        side.search_gap = side.gap;
        it.largest_gap = it.smallest_gap_raw = it.gapmin;
    } else {
        std::vector<double> raw(count);
        for (size_t i = 0; i < count; ++i) {
            const double thickness = side.contact_thickness[i] != 0 ? side.contact_thickness[i] : side.thickness[i];
            raw[i] = 0.5 * it.fscalegap * thickness;
            side.gap.push_back(std::max(it.gapmin.value, std::min(raw[i], it.gapmax.value)));
        }
        it.largest_gap = *std::max_element(side.gap.begin(), side.gap.end());
        it.smallest_gap_raw = *std::min_element(raw.begin(), raw.end());
        const CardReading reading = validator.reading();
        for (size_t i = 0; i < count; ++i)
            side.search_gap.push_back(reading.search_gap(it, raw[i], side.gap[i]));
    }
    resolve_depth(validator);
}

}  // namespace type21
