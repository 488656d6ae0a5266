/// @file Which degrees of freedom are fixed, driven or free.
#pragma once

#include <array>
#include <vector>

#include "reference/deck/problem.h"
#include "reference/model/host_scene.h"

namespace type21 {

/// What acts on the six degrees of freedom of one node (translations 0..2, rotations 3..5).
struct NodeConditions {
    std::array<bool, 6> fixed{};
    std::array<int, 6> imposed{-1, -1, -1, -1, -1, -1};  ///< index into Model::imposed_motions, -1: none

    bool driven(int direction) const {
        const auto d = static_cast<size_t>(direction);
        return fixed[d] || imposed[d] >= 0;
    }
};

/// One for each node of the Model. Where two imposed motions meet on a node and direction the later of the deck holds.
std::vector<NodeConditions> node_conditions(const Model& model);

/// Rigid body of each node, -1 where there is none; the main nodes belong to their body.
std::vector<int> bodies_of_nodes(const Model& model);

/// Checks a scene before it is run. Errors are a free node of a deformable element (its element forces are not computed
/// in this version), a free node or tool without mass, no end time. All problems at once.
/// @param needs_end  false where no engine deck is asked for: the end time may then be missing
void check_runnable(const HostScene& scene, Problems& problems, bool needs_end = true);

}  // namespace type21
