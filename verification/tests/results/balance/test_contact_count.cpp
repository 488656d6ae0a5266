#include <gtest/gtest.h>

#include "verification/results/balance/contact_count.h"
#include "verification/tests/results/record/record_scene.h"

namespace type21 {
namespace {

TEST(ContactCount, FollowsTheNodesAndTheDeepestPenetration) {
    test::RecordScene small;
    small.model->interfaces[0].secondary.node = {0, 1};
    test::Cycle cycle;
    ContactCounter counter(small.scene);
    std::vector<NodeContact>& nodes = cycle.contacts[0].nodes;
    nodes.resize(2);
    nodes[0].decision.kind = Kind::contact;
    nodes[0].status = Status::stick;
    nodes[0].geometric_penetration = 0.5;
    nodes[1].decision.kind = Kind::contact;
    nodes[1].status = Status::slip;
    nodes[1].geometric_penetration = 0.75;
    counter.observe(cycle.record(0, 2, 0, 1, false));
    nodes[1] = {};
    counter.observe(cycle.record(1, 3, 1, 1, false));
    nodes[0].decision.kind = Kind::proximity;  // heat only: no contact
    counter.observe(cycle.record(2, 4, 1, 1, true));

    const ContactCount& count = counter.result()[0];
    EXPECT_EQ(count.nodes, 2);
    EXPECT_EQ(count.in_contact, 0);
    EXPECT_EQ(count.most_in_contact, 2);
    EXPECT_EQ(count.cycles_in_contact, 2);
    EXPECT_EQ(count.sticking + count.sliding, 0);
    EXPECT_EQ(count.deepest, 0.75);
    EXPECT_EQ(count.deepest_node, 1);
    EXPECT_EQ(count.deepest_time, 2);
}

}  // namespace
}  // namespace type21
