/// @file What ParaView is shown of one interface: the blank and the tool, with the contact of a cycle on them.
#pragma once

#include <vector>

#include "reference/host/march.h"
#include "verification/results/paraview/vtu_file.h"

namespace type21 {

/// Follows one interface over all cycles: slip is a sum over them.
///
/// Arrays of the blank, one value a node of the secondary surface; all but NODE_ID, gap and slip are 0 while the node
/// is open:
///   NODE_ID           id of the node
///   SEGMENT_ID        number of the main segment of its impact, from 1
///   status            0 open, 1 stick, 2 slip
///   gap               g, of open nodes too; that of time 0 while the interface does not act [length]
///   penetration       p = max(0, p_g - P0) [length]
///   normal            nu, outward of the tool [-]
///   contact_force     on the node: F_n nu - F_t [force]
///   contact_pressure  F_n / A [pressure]
///   tangential_force  its part by friction, -F_t [force]
///   slip              path since the start: sum of |v_t| dt1 over the cycles in which the node slips [length]
/// and of its cells SEGMENT_ID, the number in the secondary surface, and ELEMENT_ID, 0 without a shell.
///
/// The tool has NODE_ID at its nodes and, on each main segment: SEGMENT_ID, ELEMENT_ID, nodes_in_contact, and of the
/// nodes whose impact is on it: gap, penetration and normal of the deepest, the sum of contact_force and of
/// tangential_force (on the tool), contact_pressure = sum of F_n / area of the segment, the largest slip, the highest
/// status.
class ContactGrid {
  public:
    ContactGrid(const HostScene& scene, int interface);

    /// Every cycle, shown or not.
    void add(const CycleRecord& record);
    VtuGrid blank(const CycleRecord& record) const;
    VtuGrid tool(const CycleRecord& record) const;
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(slip_);
    }

  private:
    const Interface& interface() const { return model_.interfaces[static_cast<size_t>(interface_)]; }
    VtuGrid grid_of(const CycleRecord& record, const std::vector<int>& nodes, int surface) const;

    const Model& model_;
    int interface_;
    std::vector<double> slip_;  ///< per secondary node [length]
};

}  // namespace type21
