/// @file Counts of the contact: nodes in contact, sticking and sliding, and the deepest penetration.
#pragma once

#include <vector>

#include "reference/host/march.h"

namespace type21 {

struct ContactCount {
    int nodes = 0;            ///< of the secondary surface
    int in_contact = 0;       ///< in the last cycle
    int most_in_contact = 0;  ///< in any cycle
    long cycles_in_contact = 0;
    int sticking = 0;         ///< in the last cycle
    int sliding = 0;          ///< in the last cycle
    double deepest = 0;       ///< largest p_g of any cycle [length]
    int deepest_node = -1;    ///< index into Model::nodes
    double deepest_time = 0;  ///< [time]
};

template <class Archive>
void visit_state(Archive& archive, ContactCount& count) {
    auto& [nodes, in_contact, most, cycles, sticking, sliding, deepest, node, time] = count;
    archive(nodes, in_contact, most, cycles, sticking, sliding, deepest, node, time);
}

class ContactCounter {
  public:
    explicit ContactCounter(const HostScene& scene);

    void observe(const CycleRecord& record);
    /// Per interface.
    const std::vector<ContactCount>& result() const { return counts_; }
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(counts_);
    }

  private:
    const Model& model_;
    std::vector<ContactCount> counts_;
};

}  // namespace type21
