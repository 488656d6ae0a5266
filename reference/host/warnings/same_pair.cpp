/// @file The same nodes against the same segments in two interfaces: every force acts twice.
#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "reference/host/warnings/warnings.h"
#include "reference/model/card_validator.h"
#include "reference/model/repeated_segments.h"

namespace type21 {
namespace {

/// The nodes of the segments of a surface, whatever node each begins with, sorted.
std::vector<std::array<int, 4>> sorted_segments(const Surface& surface) {
    std::vector<std::array<int, 4>> segments;
    segments.reserve(surface.segments.size());
    for (const Segment& segment : surface.segments)
        segments.push_back(sorted_nodes(segment));
    std::sort(segments.begin(), segments.end());
    return segments;
}

std::size_t shared_segments(const Surface& a, const Surface& b) {
    std::vector<std::array<int, 4>> shared;
    const auto first = sorted_segments(a);
    const auto second = sorted_segments(b);
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(shared));
    return shared.size();
}

std::vector<int> shared_nodes(const Interface& a, const Interface& b) {
    std::vector<int> shared;
    std::set_intersection(a.secondary.node.begin(), a.secondary.node.end(), b.secondary.node.begin(),
                          b.secondary.node.end(), std::back_inserter(shared));
    return shared;
}

/// One is over before the other begins, or sensors of their own switch them.
bool take_turns(const Interface& a, const Interface& b) {
    if (a.sens_id != 0 || b.sens_id != 0) return a.sens_id != b.sens_id;
    return a.tstop <= b.tstart || b.tstop <= a.tstart;
}

}  // namespace

void warn_of_same_pairs(const SurpriseCheck& check) {
    const auto& interfaces = check.model.interfaces;
    for (size_t j = 1; j < interfaces.size(); ++j) {
        const Interface& second = interfaces[j];
        std::vector<Id> others;
        std::vector<int> nodes;
        std::size_t segments = 0;
        for (size_t i = 0; i < j; ++i) {
            const Interface& first = interfaces[i];
            if (first.tool != second.tool || take_turns(first, second)) continue;
            const std::vector<int> both = shared_nodes(first, second);
            if (both.empty()) continue;
            const std::size_t shared = first.main_surface == second.main_surface
                                           ? check.main_surface(first).segments.size()
                                           : shared_segments(check.main_surface(first), check.main_surface(second));
            if (shared == 0) continue;
            others.push_back(first.id);
            if (others.size() > 1) continue;
            nodes = both;
            segments = shared;
        }
        if (others.empty()) continue;
        check.at_interface(
            second, "surf_IDs, surf_IDm",
            fmt::format("{} node{}, the first {}, and {} segment{}", nodes.size(), nodes.size() == 1 ? "" : "s",
                        check.model.nodes.id[static_cast<size_t>(nodes.front())], segments, segments == 1 ? "" : "s"),
            fmt::format("are in interface {} too: they act in each, so that stiffness and friction add up",
                        first_few(others)),
            "Remove one of the interfaces, or take these nodes or segments out of one of them");
    }
}

}  // namespace type21
