#include "optimized/search/sorted/sort_margin.h"

#include <algorithm>

namespace type21::optimized {

namespace {

/// The margin grows with DEPTH, since a deep search zone holds many segments and is dear to sort. The number is as
/// built.
constexpr double share_of_depth = 1.251;

/// 0 where there is no segment. A triangle repeats its third node, so one of its four sides has no length and is none.
double mean_side(const ContactModel& model, int surface) {
    if (surface < 0) return 0;
    double sum = 0;
    long sides = 0;
    for (const Segment& segment : model.surfaces[static_cast<size_t>(surface)].segments) {
        for (size_t j = 0; j < 4; ++j) {
            const int from = segment.node[j], to = segment.node[(j + 1) % 4];
            if (from == to) continue;
            sum += (model.nodes.position[static_cast<size_t>(from)] - model.nodes.position[static_cast<size_t>(to)])
                       .norm();
            ++sides;
        }
    }
    return sides > 0 ? sum / static_cast<double>(sides) : 0;
}

}  // namespace

/// @manual field Bumult
double sort_margin(const ContactModel& model, const Interface& card, double proximity, double bumult) {
    double side = mean_side(model, card.secondary_surface);
    if (!(side > 0)) side = mean_side(model, card.main_surface);
    return (bumult > 0 ? bumult : double(card.bumult)) *
           std::max({side, share_of_depth * card.depth, share_of_depth * proximity});
}

}  // namespace type21::optimized
