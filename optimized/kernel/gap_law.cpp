#include "optimized/kernel/gap_law.h"

#include <algorithm>

namespace type21::optimized {

NodeShells::NodeShells(const ContactModel& model, const std::vector<int>& nodes, bool with_material)
    : first_(nodes.size() + 1, 0) {
    const auto each = [&](const auto& act) {
        for (size_t s = 0; s < model.shells.size(); ++s) {
            const Shell& shell = model.shells[s];
            const auto material = static_cast<size_t>(model.parts[static_cast<size_t>(shell.part)].material);
            if (with_material && model.materials[material].law == MaterialLaw::none) continue;
            for (int j = 0; j < shell.corners(); ++j) {
                const int node = shell.node[static_cast<size_t>(j)];
                const auto rank = std::lower_bound(nodes.begin(), nodes.end(), node);
                if (rank != nodes.end() && *rank == node)
                    act(static_cast<size_t>(rank - nodes.begin()), static_cast<int>(s));
            }
        }
    };
    each([&](size_t i, int) { ++first_[i + 1]; });
    for (size_t i = 1; i < first_.size(); ++i)
        first_[i] += first_[i - 1];
    shell_.resize(static_cast<size_t>(first_.back()));
    std::vector<int> next(first_.begin(), first_.end() - 1);
    each([&](size_t i, int s) { shell_[static_cast<size_t>(next[i]++)] = s; });
}

GapLaw::GapLaw(const ContactModel& model, const Interface& interface)
    : card_(interface),
      from_clipped_(model.as_built.has(Departure::D30)),
      shells_(model, interface.secondary.node, true) {}

GrownGap GapLaw::at(int i, std::span<const double> thickness) const {
    const auto n = static_cast<size_t>(i);
    const SecondarySide& side = card_.secondary;
    double now = side.thickness[n];
    if (!thickness.empty()) {
        now = 0;
        for (const int s : shells_.at(i))
            now = std::max(now, thickness[static_cast<size_t>(s)]);
    }
    const double thick = side.contact_thickness[n] != 0 ? side.contact_thickness[n] : side.thickness[n];
    const double half = 0.5 * card_.fscalegap;
    const double start = from_clipped_ ? side.gap[n] : half * thick;
    GrownGap gap;
    gap.raw = std::max(start + half * (now - side.thickness[n]), 0.0);
    gap.clipped = std::max(double(card_.gapmin), std::min(gap.raw, double(card_.gapmax)));
    return gap;
}

}  // namespace type21::optimized
