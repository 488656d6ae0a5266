/// @file Which degrees of freedom are fixed, driven or free.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reference/deck/problem.h"
#include "reference/model/host_scene.h"

namespace type21 {

/// What acts on the six degrees of freedom of one node (translations 0..2, rotations 3..5), in the axes of a skew where
/// its conditions name one, else in global axes.
struct NodeConditions {
    std::array<bool, 6> fixed{};
    std::array<int, 6> imposed{-1, -1, -1, -1, -1, -1};  ///< index into Model::imposed_motions, -1: none

    std::array<int, 2> skew{-1, -1};  ///< of translations and rotations: index into Model::skews, -1: global axes

    bool driven(int direction) const {
        const auto d = static_cast<size_t>(direction);
        return fixed[d] || imposed[d] >= 0;
    }
};

/// A condition whose direction is none of the axes of the others of its node.
struct ConditionConflict {
    int node = -1;     ///< index into Model::nodes
    std::string card;  ///< "/BCS/3"
};

/// One for each node of the Model. Where two imposed motions meet on a node and direction the later of the deck holds.
/// The conditions of a node hold in the axes of the first skew that one of them names; a condition in other axes must
/// have a direction of these, too.
/// @param conflicts  those that have not and are left out; may be null.  Formulation 11, step 4.
std::vector<NodeConditions> node_conditions(const Model& model, std::vector<ConditionConflict>* conflicts = nullptr);

/// Rigid body of each node, -1 where there is none; the main nodes belong to their body.
std::vector<int> bodies_of_nodes(const Model& model);

/// Checks a scene before it is run. Errors are a free node of a deformable element (its element forces are not computed
/// in this version), a free node or tool without mass, no end time. All problems at once.
/// @param needs_end  false where no engine deck is asked for: the end time may then be missing
void check_runnable(const HostScene& scene, Problems& problems, bool needs_end = true);

}  // namespace type21
