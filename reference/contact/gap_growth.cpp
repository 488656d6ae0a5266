#include "reference/contact/gap_growth.h"

#include <algorithm>

namespace type21::reference {

NodalGap grown_gap(const Interface& interface, double initial, double clipped0, double change,
                   const AsBuilt& as_built) {
    const double growth = 0.5 * interface.fscalegap * change;
    const double start = as_built.has(Departure::D30) ? clipped0 : 0.5 * interface.fscalegap * initial;
    NodalGap gap;
    gap.raw = std::max(0.0, start + growth);
    gap.clipped = std::max<double>(interface.gapmin, std::min<double>(gap.raw, interface.gapmax));
    return gap;
}

GapGrowth::GapGrowth(const ContactModel& model, const Interface& interface)
    : model_(model), interface_(interface), shells_(static_cast<size_t>(interface.secondary.size())) {
    const auto& nodes = interface.secondary.node;
    for (size_t s = 0; s < model.shells.size(); ++s) {
        const Shell& shell = model.shells[s];
        const Part& part = model.parts[static_cast<size_t>(shell.part)];
        if (model.materials[static_cast<size_t>(part.material)].law == MaterialLaw::none) continue;
        for (int j = 0; j < shell.corners(); ++j) {
            const int node = shell.node[static_cast<size_t>(j)];
            const auto at = std::lower_bound(nodes.begin(), nodes.end(), node);
            if (at != nodes.end() && *at == node)
                shells_[static_cast<size_t>(at - nodes.begin())].push_back(static_cast<int>(s));
        }
    }
}

NodalGap GapGrowth::gap(int i, std::span<const double> thickness) const {
    const auto n = static_cast<size_t>(i);
    const SecondarySide& side = interface_.secondary;
    double now = side.thickness[n];
    if (!thickness.empty()) {
        now = 0;
        for (const int shell : shells_[n])
            now = std::max(now, thickness[static_cast<size_t>(shell)]);
    }
    const double initial = side.contact_thickness[n] != 0 ? side.contact_thickness[n] : side.thickness[n];
    return grown_gap(interface_, initial, side.gap[n], now - side.thickness[n], model_.as_built);
}

}  // namespace type21::reference
