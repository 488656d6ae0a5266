/// @file Gaps that follow the thickness of the sheet, and nodes that leave with their shells (Formulation 2, step 5;
/// Formulation 9, step 3).
#pragma once

#include <span>
#include <vector>

#include "reference/contract/scene.h"

namespace type21::optimized {

/// The shells at each secondary node, one after the other.
class NodeShells {
  public:
    /// @param with_material  false: all; true: void shells are left out
    NodeShells(const ContactModel& model, const std::vector<int>& nodes, bool with_material);
    std::span<const int> at(int i) const {
        const auto n = static_cast<size_t>(i);
        return {shell_.data() + first_[n], static_cast<size_t>(first_[n + 1] - first_[n])};
    }
    size_t bytes() const { return (shell_.size() + first_.size()) * sizeof(int); }

  private:
    std::vector<int> first_, shell_;
};

/// g and g_s of a node with Igap 2.
struct GrownGap {
    double raw = 0;      ///< g_s [length]
    double clipped = 0;  ///< g [length]
};

/// @manual eq 2, 4; field Igap, Fscalegap, Gapmin, Gapmax; comment 2; departure D30
class GapLaw {
  public:
    GapLaw(const ContactModel& model, const Interface& interface);
    /// @param thickness  of each of Model::shells [length]; empty: as at time 0
    GrownGap at(int i, std::span<const double> thickness) const;
    size_t bytes() const { return shells_.bytes(); }

  private:
    const Interface& card_;
    bool from_clipped_;
    NodeShells shells_;
};

}  // namespace type21::optimized
