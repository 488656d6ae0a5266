/// @file Gap that follows the thickness of the sheet, Igap 2 (page comment 2, equations (2) and (4); formulation
/// section 2).
#pragma once

#include <span>
#include <vector>

#include "reference/contract/scene.h"

namespace type21::reference {

/// g = max(Gapmin, min(g_s, Gapmax)),  g_s = max(0, Fscalegap (t_c or else t0) / 2 + Fscalegap (t_n - t0) / 2)
/// D30: the gap clipped at time 0, plus the change of thickness, clipped again.
struct NodalGap {
    double raw = 0;      ///< g_s, before Gapmin and Gapmax act [length]
    double clipped = 0;  ///< g [length]
};

/// @param initial    t_c, or t0 where there is none [length]
/// @param clipped0   g0, the gap at time 0 [length]
/// @param change     t_n - t0 [length]
/// @manual eq 2, 4; field Igap, Fscalegap, Gapmin, Gapmax; comment 2; departure D30
NodalGap grown_gap(const Interface& interface, double initial, double clipped0, double change, const AsBuilt& as_built);

/// The room of Igap 2: which shells decide the thickness of a node. Present only when the scene asks for it.
class GapGrowth {
  public:
    GapGrowth(const ContactModel& model, const Interface& interface);

    /// @param i          secondary node
    /// @param thickness  of each of Model::shells [length]; empty: nothing has changed
    NodalGap gap(int i, std::span<const double> thickness) const;

    static constexpr size_t bytes_per_node() { return sizeof(std::vector<int>); }

  private:
    const ContactModel& model_;
    const Interface& interface_;
    std::vector<std::vector<int>> shells_;  ///< at each node, void ones excluded
};

}  // namespace type21::reference
