#include "reference/contact/node_parts.h"

#include <algorithm>

namespace type21::reference {

std::vector<int> node_parts(const ContactModel& model, const Interface& interface) {
    const auto& nodes = interface.secondary.node;
    std::vector<int> parts(nodes.size(), -1);
    for (const Segment& segment : model.surfaces[static_cast<size_t>(interface.secondary_surface)].segments) {
        if (segment.shell < 0) continue;
        for (const int node : segment.node) {
            const auto at = std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin();
            int& part = parts[static_cast<size_t>(at)];
            if (part < 0) part = model.shells[static_cast<size_t>(segment.shell)].part;
        }
    }
    return parts;
}

}  // namespace type21::reference
