#include "reference/as_built/d42_node_parts.h"

#include <algorithm>

namespace type21::reference::as_built {

namespace {

std::vector<bool> parts_in_pairs(const ContactModel& model, const Interface& interface) {
    std::vector<bool> named(model.parts.size(), false);
    if (interface.friction_model < 0) return named;
    for (const FrictionPair& pair : model.friction_models[static_cast<size_t>(interface.friction_model)].pairs) {
        for (const int part : {pair.part_a, pair.part_b})
            if (part >= 0) named[static_cast<size_t>(part)] = true;
    }
    return named;
}

}  // namespace

std::vector<int> node_parts(const ContactModel& model, const Interface& interface) {
    const std::vector<bool> named = parts_in_pairs(model, interface);
    const auto& nodes = interface.secondary.node;
    std::vector<int> parts(nodes.size(), -1);
    for (const Segment& segment : model.surfaces[static_cast<size_t>(interface.secondary_surface)].segments) {
        if (segment.shell < 0) continue;
        const int part = model.shells[static_cast<size_t>(segment.shell)].part;
        if (!named[static_cast<size_t>(part)]) continue;
        for (const int node : segment.node) {
            const auto at = std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin();
            int& last = parts[static_cast<size_t>(at)];
            last = std::max(last, part);
        }
    }
    return parts;
}

}  // namespace type21::reference::as_built
