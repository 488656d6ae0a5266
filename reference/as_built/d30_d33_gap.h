/// @file D30, D33: the gap of Igap 2, and the gap that decides contact.
#pragma once

#include <algorithm>

#include "reference/contact/gap_growth.h"

namespace type21::reference::as_built {

/// As documented: the gap follows the current thickness, then Gapmin and Gapmax bound it.
/// As built: the bounded gap of time 0 plus the change of thickness, bounded again.
/// @return [length].  Formulation 12, step 2; Formulation 2, step 5.
/// @manual departure D30
inline NodalGap grown_gap(const Interface& interface, const SheetThickness& sheet) {
    const double growth = 0.5 * interface.fscalegap * sheet.change;
    const double raw = std::max(0.0, sheet.initial_gap + growth);
    return {raw, bounded_gap(interface, raw)};
}

/// As documented: a node's own gap decides contact.
/// As built: the larger of min(g_s, Gapmax) and the largest gap of the interface at time 0. A node that only this
/// retains at time 0 begins its count of cycles (ContactReading::counts_without_penetration).
/// @return [length].  Formulation 12, step 2; Formulation 2, step 7.
/// @manual departure D33
inline double search_gap(const Interface& interface, const NodalGap& gap) {
    return std::max(std::min<double>(gap.raw, interface.gapmax), interface.largest_gap);
}

}  // namespace type21::reference::as_built
