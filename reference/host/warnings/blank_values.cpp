/// @file A blank without thickness, and coordinates beside which the gap loses its digits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "reference/host/warnings/warnings.h"
#include "reference/model/card_validator.h"
#include "reference/model/nodal_gaps.h"

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

}  // namespace

void warn_of_void_blanks(const SurpriseCheck& check) {
    std::vector<bool> is_void;
    for (const Interface& interface : check.model.interfaces) {
        if (interface.igap == 0) continue;
        if (is_void.empty()) is_void = nodes_of_void_shells(check.model);
        std::vector<Id> nodes;
        for (size_t i = 0; i < interface.secondary.node.size(); ++i) {
            const int node = interface.secondary.node[i];
            if (interface.secondary.gap[i] == 0 && is_void[at(node)]) nodes.push_back(check.model.nodes.id[at(node)]);
        }
        if (nodes.empty()) continue;
        check.at_interface(
            interface, "Igap",
            fmt::format("{}, {} node{}: {}", interface.igap.value, nodes.size(), nodes.size() == 1 ? "" : "s",
                        first_few(nodes)),
            fmt::format("the shells at these nodes are void, and void shells count without thickness: the gap is {}, "
                        "and there is no contact before a node is behind the tool",
                        check.quantity(0, dim::length)),
            "Give the blank a material that is not void, a contact thickness on its /PART, Gapmin, or Igap 0 with "
            "Gapmin");
    }
}

void warn_of_far_coordinates(const SurpriseCheck& check) {
    // A forming scene keeps 11 to 13 digits of its gap; below 9 the histories differ visibly from those of the same
    // scene at the origin.
    constexpr double fewest_digits = 9.5;
    const auto& x = check.model.nodes.position;
    for (const Interface& interface : check.model.interfaces) {
        double farthest = 0;
        int node = -1;
        const auto look = [&](const std::vector<int>& nodes) {
            for (const int n : nodes) {
                const double size = x[at(n)].cwiseAbs().maxCoeff();
                if (size > farthest) {
                    farthest = size;
                    node = n;
                }
            }
        };
        look(interface.secondary.node);
        look(interface.main_nodes);
        double gap = std::numeric_limits<double>::infinity();
        for (const double g : interface.secondary.gap)
            if (g > 0) gap = std::min(gap, g);
        if (node < 0 || !std::isfinite(gap)) continue;
        const double digits = std::log10(gap / (std::numeric_limits<double>::epsilon() * farthest));
        if (digits >= fewest_digits) continue;
        check.at_interface(
            interface, "surf_IDs",
            fmt::format("node {} at {}", check.model.nodes.id[at(node)], check.quantity(farthest, dim::length)),
            fmt::format(
                "lies so far from the origin that the gap {} keeps {:.0f} of 16 digits, if the deck gives as many",
                check.quantity(gap, dim::length), std::max(digits, 0.0)),
            "Move the scene to the origin");
    }
}

}  // namespace type21
