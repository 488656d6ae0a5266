#include "reference/contact/gap_growth.h"

#include <algorithm>

namespace type21::reference {

double bounded_gap(const Interface& interface, double raw) {
    return std::max<double>(interface.gapmin, std::min<double>(raw, interface.gapmax));
}

NodalGap grown_gap(const Interface& interface, const SheetThickness& sheet) {
    const double start = 0.5 * interface.fscalegap * sheet.initial;
    const double growth = 0.5 * interface.fscalegap * sheet.change;
    const double raw = std::max(0.0, start + growth);
    return {raw, bounded_gap(interface, raw)};
}

double search_gap(const Interface& /*interface*/, const NodalGap& gap) {
    return gap.clipped;
}

GapGrowth::GapGrowth(const ContactModel& model, const Interface& interface)
    : interface_(interface), shells_(static_cast<size_t>(interface.secondary.size())) {
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

SheetThickness GapGrowth::sheet(int i, std::span<const double> thickness) const {
    const auto n = static_cast<size_t>(i);
    const SecondarySide& side = interface_.secondary;
    double now = side.thickness[n];
    if (!thickness.empty()) {
        now = 0;
        for (const int shell : shells_[n])
            now = std::max(now, thickness[static_cast<size_t>(shell)]);
    }
    const double initial = side.contact_thickness[n] != 0 ? side.contact_thickness[n] : side.thickness[n];
    return {initial, now - side.thickness[n], side.gap[n]};
}

}  // namespace type21::reference
