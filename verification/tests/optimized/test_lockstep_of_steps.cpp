// Reference and optimized contact stepped with the same motion: the same decisions, forces equal to a few ulps.
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "optimized/contact.h"
#include "optimized/search/search.h"
#include "reference/as_built/d34_reach_box.h"
#include "reference/contract/make_contact.h"
#include "reference/cycle/contact.h"
#include "reference/deck/deck.h"
#include "reference/host/march.h"
#include "reference/model/resolve.h"
#include "verification/tests/optimized/test_tools.h"

namespace type21 {
namespace {

using optimized::V3;

HostScene scene_of(const std::string& name, const AsBuilt& as_built) {
    Problems problems;
    const Deck deck = read_deck(TYPE21_SOURCE_DIR "/cases/" + name + "/" + name + "_0000.rad", problems);
    auto model = std::make_shared<const Model>(resolve(deck, as_built, problems));
    EXPECT_FALSE(problems.has_errors());
    return plan(std::move(model));
}

bool same(const Decision& one, const Decision& other) {
    return one.kind == other.kind && one.segment == other.segment && one.triangle == other.triangle &&
           one.side == other.side;
}

/// What integers say of secondary node i over all segments, without filter, certificate and tree.
class Truth {
  public:
    Truth(const Scene& scene, int interface)
        : model_(*scene.model), card_(model_.interfaces[static_cast<size_t>(interface)]), tool_(model_, card_) {
        rules_.proximity_competes = model_.as_built.has(Departure::D11);
        rules_.lift_leaning = model_.as_built.has(Departure::D35);
        if (card_.ithe != 0) {
            if (card_.frad > 0 || rules_.proximity_competes) proximity_ = card_.drad;
            if (card_.function_distance >= 0) proximity_ = std::max(proximity_, double(card_.dcond));
        }
        boxes_.on = model_.as_built.has(Departure::D34);
        boxes_.proximity = proximity_;
        if (card_.tool_rotates)
            boxes_.axes =
                reference::as_built::reach_box_axes(model_.rigid_bodies[static_cast<size_t>(card_.tool)], true);
    }
    bool agrees(const Decision& d, const Vec3& y, double gap) const {
        const optimized::ContactReach reach{gap, card_.depth, proximity_};
        const auto truth = optimized::testing::exhaustive(
            tool_, optimized::from(y), reach, rules_,
            [&](const optimized::SegmentData& s) { return boxes_.holds(optimized::from(y), s, reach); });
        return truth.id == optimized::SubTriangleId(d.segment, d.triangle) && truth.projection.side == d.side &&
               truth.projection.kind == d.kind;
    }

  private:
    const ContactModel& model_;
    const Interface& card_;
    optimized::Tool tool_;
    optimized::ProjectionLimits rules_;
    optimized::ReachBoxRule boxes_;
    double proximity_ = 0;
};

struct Comparison {
    long nodes = 0, closed = 0;
    long differ = 0;         ///< decisions
    long not_the_truth = 0;  ///< of these, the optimized is wrong
    double force = 0;        ///< largest difference of a component of force [ulps of the scale]
    double sums = 0;         ///< of the tool's force, likewise
};

/// Steps both; the march goes on with the optimized one.
class Both final : public ContactMethod {
  public:
    Both(const Scene& scene, int interface, Comparison& result, bool forces)
        : card_(scene.model->interfaces[static_cast<size_t>(interface)]),
          reference_(scene, interface),
          optimized_(scene, interface),
          truth_(scene, interface),
          result_(result),
          forces_(forces) {}

    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override {
        const auto theirs = reference_.initial_penetrations(position);
        auto ours = optimized_.initial_penetrations(position);
        EXPECT_EQ(theirs.size(), ours.size());
        return ours;
    }
    std::vector<EffectMemory> memory_by_effect() const override { return optimized_.memory_by_effect(); }
    DecisionStageCounts decision_stage_counts() const override { return optimized_.decision_stage_counts(); }

    ContactStep step(const Motion& motion) override {
        const ContactStep theirs = reference_.step(motion);
        ContactStep ours = optimized_.step(motion);
        EXPECT_EQ(theirs.nodes.size(), ours.nodes.size());
        double scale_of_sum = 0;
        for (size_t i = 0; i < ours.nodes.size(); ++i)
            scale_of_sum += compare(i, theirs.nodes[i], ours.nodes[i], motion);
        const double off = (theirs.tool.force - ours.tool.force).cwiseAbs().maxCoeff();
        if (off > 0 && forces_ && other_history_.empty())
            result_.sums = std::max(result_.sums, off / (0x1p-52 * scale_of_sum));
        return ours;
    }

  private:
    /// @return the scale of the node's force: what one unit in the last place is taken of
    double compare(size_t i, const NodeContact& theirs, const NodeContact& ours, const Motion& motion) {
        const ToolMotion& pose = motion.tools[static_cast<size_t>(card_.tool)];
        const Vec3 y =
            pose.rotation.transpose() * (motion.position[static_cast<size_t>(card_.secondary.node[i])] - pose.position);
        // The penetration is the small difference of the gap and of coordinates: k times these is the scale.
        const double k = std::max(theirs.stiffness, ours.stiffness);
        const double scale = k * (y.cwiseAbs().maxCoeff() + ours.gap) + theirs.force.norm() +
                             theirs.damping * theirs.relative_velocity.norm();
        ++result_.nodes;
        result_.closed += ours.status != Status::open;
        if (!same(theirs.decision, ours.decision)) {
            ++result_.differ;
            result_.not_the_truth += !truth_.agrees(ours.decision, y, ours.gap);
            other_history_.insert(i);
        }
        if (other_history_.count(i) != 0 || !forces_) return scale;
        const double off = (theirs.force - ours.force).cwiseAbs().maxCoeff();
        if (off > 0) result_.force = std::max(result_.force, off / (0x1p-52 * scale));
        // Whether a penetration of a few units in the last place is one hangs on rounding, and its force is as small.
        const double rounding = 16 * 0x1p-52 * (y.cwiseAbs().maxCoeff() + ours.gap);
        if (std::max(theirs.penetration, ours.penetration) > rounding) {
            EXPECT_EQ(theirs.status, ours.status) << "node " << i;
        }
        return scale;
    }

    const Interface& card_;
    reference::Contact reference_;
    optimized::Contact optimized_;
    Truth truth_;
    Comparison& result_;
    bool forces_;
    std::set<size_t> other_history_;  ///< nodes whose decisions once differed: their histories do, too
};

/// @param forces  false: only decisions are compared
Comparison lockstep(const HostScene& scene, bool forces = true) {
    Comparison result;
    march(
        scene, [&](const Scene& s, int i) { return std::make_unique<Both>(s, i, result, forces); },
        [](const CycleRecord&) {});
    return result;
}

class Lockstep : public ::testing::TestWithParam<const char*> {};

TEST_P(Lockstep, SameDecisionsAndForces) {
    // D12 takes the direction of a small difference of two points: its forces are noise near the surface, see below.
    AsBuilt all = AsBuilt::all();
    all.set(Departure::D12, false);
    for (const AsBuilt& as_built : {AsBuilt{}, all}) {
        const Comparison c = lockstep(scene_of(GetParam(), as_built));
        EXPECT_GT(c.closed, 0);
        EXPECT_EQ(c.differ, 0) << "decisions; in " << c.not_the_truth << " of them the optimized contact is wrong";
        // The bound that the optimized implementation promises: 4 units in the last place of the magnitudes.
        EXPECT_LE(c.force, 4.0);
        EXPECT_LE(c.sums, 4.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Cases, Lockstep,
                         ::testing::Values("fric0_table", "fric2_card", "fric3_table", "fric4_card", "filter1",
                                           "filter3_low", "igap2_pmax_itlim0", "igap2_fscale", "inacti_5", "inacti_6",
                                           "therm_form1_heat", "therm_rad_dist", "rotating_tool", "tool_drop_idref",
                                           "two_sheets", "istf1_stfac", "edge_convex", "turning_disc"),
                         [](const auto& name) { return std::string(name.param); });

TEST(LockstepAsBuilt, AllDeparturesTakeTheSameDecisions) {
    for (const char* name : {"edge_convex", "rotating_tool", "therm_rad", "cylinder_slide_warped"}) {
        const Comparison c = lockstep(scene_of(name, AsBuilt::all()), false);
        EXPECT_GT(c.closed, 0) << name;
        EXPECT_EQ(c.differ, 0) << name << "; in " << c.not_the_truth << " the optimized contact is wrong";
    }
}

TEST(OptimizedContact, AnInterfaceThatIsNotThereIsNamed) {
    Scene scene;
    scene.model = std::make_shared<const ContactModel>();
    for (const int interface : {-1, 0}) {
        try {
            optimized::make_contact(scene, interface);
            FAIL() << interface;
        } catch (const std::out_of_range& error) {
            EXPECT_EQ(std::string(error.what()),
                      "there is no interface " + std::to_string(interface) + ": the model has 0, counted from 0");
        }
    }
}

}  // namespace
}  // namespace type21
