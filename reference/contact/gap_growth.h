/// @file Gap that follows the thickness of the sheet, Igap 2 (Formulation 2, step 5).
#pragma once

#include <span>
#include <vector>

#include "reference/contract/scene.h"

namespace type21::reference {

/// Thickness of the sheet at a node, and its gap at time 0.
struct SheetThickness {
    double initial = 0;      ///< t_c, or t0 where the part has no contact thickness [length]
    double change = 0;       ///< t_n - t0 [length]
    double initial_gap = 0;  ///< g0, between Gapmin and Gapmax; only D30 reads it [length]
};

/// Gap of a node in one cycle.
struct NodalGap {
    double raw = 0;      ///< g_s, before Gapmin and Gapmax act [length]
    double clipped = 0;  ///< g [length]
};

/// g_s between the bounds of the card: max(Gapmin, min(g_s, Gapmax)).
/// @param raw  g_s [length]
/// @return g [length].  Formulation 2, step 6.
double bounded_gap(const Interface& interface, double raw);

/// g = max(Gapmin, min(g_s, Gapmax)),  g_s = max(0, Fscalegap (t_c or else t0) / 2 + Fscalegap (t_n - t0) / 2)
/// @return [length].  Formulation 2, step 5; manual page, comment 2, equations (2) and (4); as built: D30.
/// @manual eq 2, 4; field Igap, Fscalegap, Gapmin, Gapmax; comment 2
NodalGap grown_gap(const Interface& interface, const SheetThickness& sheet);

/// Gap that decides contact: g, the node's own.
/// @return [length].  Formulation 2, step 7; as built: D33.
double search_gap(const Interface& interface, const NodalGap& gap);

/// Igap 2: which shells decide the thickness of a node. Present only when the scene asks for it.
class GapGrowth {
  public:
    GapGrowth(const ContactModel& model, const Interface& interface);

    /// Thickness at secondary node i (its rank in SecondarySide::node): the largest of its shells.
    /// @param thickness  of each of ContactModel::shells [length]; empty: nothing has changed
    /// @manual eq 2, 4; field Igap
    SheetThickness sheet(int i, std::span<const double> thickness) const;

    static constexpr size_t bytes_per_node() { return sizeof(std::vector<int>); }

  private:
    const Interface& interface_;
    std::vector<std::vector<int>> shells_;  ///< at each node, void ones excluded
};

}  // namespace type21::reference
