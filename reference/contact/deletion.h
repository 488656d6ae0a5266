/// @file Idel: a node whose elements are all deleted leaves the interface (manual page: Idel; Formulation 9, step 3).
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "reference/contract/scene.h"

namespace type21::reference {

/// The shells at each secondary node. A shell of thickness 0 is a deleted one. Present only when the card asks for
/// Idel.
/// @manual field Idel
class Deletion {
  public:
    Deletion(const ContactModel& model, const Interface& interface)
        : shells_(static_cast<size_t>(interface.secondary.size())) {
        const auto& nodes = interface.secondary.node;
        for (size_t s = 0; s < model.shells.size(); ++s) {
            const Shell& shell = model.shells[s];
            for (int j = 0; j < shell.corners(); ++j) {
                const int node = shell.node[static_cast<size_t>(j)];
                const auto at = std::lower_bound(nodes.begin(), nodes.end(), node);
                if (at != nodes.end() && *at == node)
                    shells_[static_cast<size_t>(at - nodes.begin())].push_back(static_cast<int>(s));
            }
        }
    }

    /// Whether all shells at the node are deleted; false for a node without shells.
    /// @param i          rank in SecondarySide::node, not checked
    /// @param thickness  of each of ContactModel::shells [length]; empty: nothing is deleted
    bool deleted(int i, std::span<const double> thickness) const {
        const auto& shells = shells_[static_cast<size_t>(i)];
        return !thickness.empty() && !shells.empty() &&
               std::all_of(shells.begin(), shells.end(), [&](int s) { return thickness[static_cast<size_t>(s)] <= 0; });
    }

    static constexpr size_t bytes_per_node() { return sizeof(std::vector<int>) + 4 * sizeof(int); }

  private:
    std::vector<std::vector<int>> shells_;
};

}  // namespace type21::reference
