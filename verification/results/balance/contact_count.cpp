#include "verification/results/balance/contact_count.h"

#include <algorithm>

namespace type21 {

ContactCounter::ContactCounter(const HostScene& scene) : model_(*scene.host), counts_(model_.interfaces.size()) {
    for (size_t i = 0; i < counts_.size(); ++i)
        counts_[i].nodes = model_.interfaces[i].secondary.size();
}

void ContactCounter::observe(const CycleRecord& record) {
    for (size_t i = 0; i < counts_.size(); ++i) {
        ContactCount& count = counts_[i];
        count.in_contact = count.sticking = count.sliding = 0;
        const std::vector<NodeContact>& nodes = (*record.contacts)[i].nodes;
        for (size_t n = 0; n < nodes.size(); ++n) {
            if (nodes[n].decision.kind != Kind::contact) continue;
            ++count.in_contact;
            if (nodes[n].status == Status::stick) ++count.sticking;
            if (nodes[n].status == Status::slip) ++count.sliding;
            if (nodes[n].geometric_penetration > count.deepest) {
                count.deepest = nodes[n].geometric_penetration;
                count.deepest_node = model_.interfaces[i].secondary.node[n];
                count.deepest_time = record.time;
            }
        }
        count.most_in_contact = std::max(count.most_in_contact, count.in_contact);
        if (count.in_contact > 0) ++count.cycles_in_contact;
    }
}

}  // namespace type21
