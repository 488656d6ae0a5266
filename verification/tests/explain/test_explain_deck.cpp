// One node at one time: the account's force is the run's, and its words say what happened.
#include <algorithm>

#include <gtest/gtest.h>

#include "../contact/small_scene.h"
#include "reference/host/prepare_deck.h"
#include "verification/explain/account_json.h"
#include "verification/explain/explain_deck.h"

namespace type21 {
namespace {

using test::over_a_square;

std::string case_deck(const std::string& name) {
    return TYPE21_SOURCE_DIR "/cases/" + name + "/" + name + "_0000.rad";
}

PreparedDeck prepared(const std::string& name, const std::string& as_built) {
    PreparedDeck deck = prepare_deck(case_deck(name), as_built, true);
    EXPECT_TRUE(deck.scene) << name;
    return deck;
}

/// The contacts of all secondary nodes of the first interface in every cycle of a run, and the times.
struct History {
    std::vector<double> time;
    std::vector<std::vector<NodeContact>> nodes;

    /// Rank of the node that has force most often.
    size_t busiest() const {
        std::vector<int> count(nodes.front().size());
        for (const auto& cycle : nodes)
            for (size_t i = 0; i < cycle.size(); ++i)
                count[i] += cycle[i].force.isZero(0.0) ? 0 : 1;
        return static_cast<size_t>(std::max_element(count.begin(), count.end()) - count.begin());
    }
};

History history(const PreparedDeck& deck) {
    History out;
    const size_t count = static_cast<size_t>(deck.scene->model->interfaces[0].secondary.size());
    const MakeContact make = [](const Scene& s, int i) { return std::make_unique<reference::Contact>(s, i); };
    march(
        *deck.scene, make,
        [&](const CycleRecord& record) {
            out.time.push_back(record.time);
            out.nodes.push_back(record.contacts->front().nodes);
            out.nodes.back().resize(count);  // empty while inactive
        },
        deck.options());
    return out;
}

struct Scenario {
    const char* name;
    const char* as_built;
};

class EveryForce : public testing::TestWithParam<Scenario> {};

// The force of the account, computed again from the laws, is that of the run to the last bit: over a whole run of one
// node, in scenes with each effect.
TEST_P(EveryForce, IsTheRunsToTheLastBit) {
    const PreparedDeck deck = prepared(GetParam().name, GetParam().as_built);
    const HostScene& scene = *deck.scene;
    const Interface& card = scene.model->interfaces[0];
    const History run = history(deck);
    const size_t rank = run.busiest();
    const Id node = scene.model->nodes.id[static_cast<size_t>(card.secondary.node[rank])];
    int with_force = 0;
    for (size_t cycle = 0; cycle < run.time.size(); cycle += 1 + run.time.size() / 25) {
        const DeckAccount account = explain_deck(scene, {node, run.time[cycle], card.id}, deck.options());
        ASSERT_EQ(account.cycle, static_cast<long>(cycle));
        ASSERT_EQ(account.interfaces.size(), 1u);
        const NodeAccount& of = account.interfaces[0];
        EXPECT_TRUE(of.agrees) << "cycle " << cycle << "\n" << account_text(account, *scene.host);
        ASSERT_EQ(of.node.force, run.nodes[cycle][rank].force) << "cycle " << cycle;
        if (!of.replay.impact) continue;
        EXPECT_EQ(of.replay.force, run.nodes[cycle][rank].force) << "cycle " << cycle;
        // The doubles that are shown may err where the bound on their error could not tell, and only there.
        if (of.node.decision.stage == Stage::bounded) {
            EXPECT_EQ(of.candidates.retained.segment, of.node.decision.segment);
            EXPECT_EQ(of.candidates.retained.triangle, of.node.decision.triangle);
        }
        with_force += of.replay.force.isZero(0.0) ? 0 : 1;
    }
    EXPECT_GT(with_force, 2) << "a scene without force shows nothing";
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, EveryForce,
    testing::Values(Scenario{"cylinder_slide", ""}, Scenario{"cylinder_slide", "all"}, Scenario{"fric_reversal", ""},
                    Scenario{"inacti_6", ""}, Scenario{"inacti_5", "all"}, Scenario{"impact_relax", "all"},
                    Scenario{"istf1_stfac", "all"}, Scenario{"rotating_tool", "all"}, Scenario{"filter1", ""},
                    Scenario{"fric2_table", ""}, Scenario{"therm_fctidf_asc1", ""},
                    Scenario{"therm_form1_heat", "all"}),
    [](const auto& p) { return std::string(p.param.name) + (p.param.as_built[0] != 0 ? "_as_built" : "_documented"); });

SceneBuilder resting(const Vec3& blank) {
    SceneBuilder small = over_a_square({blank});
    small.fix(0, {true, true, true, true, true, true});
    small.fix(small.blank_node(0), {true, true, true, true, true, true});
    small.model().engine.end_time = 0.01;
    return small;
}

Id blank_id(SceneBuilder& small) {
    return small.model().nodes.id[static_cast<size_t>(small.blank_node(0))];
}

TEST(ExplainDeck, TheNumbersOfAHandCalculation) {
    SceneBuilder small = resting({0.2, 0.1, 0.3});
    const DeckAccount account = explain_deck(small.scene(), {blank_id(small), 0.0, {}});
    const NodeAccount& of = account.interfaces.at(0);
    EXPECT_EQ(of.candidates.segments.size(), 1u);
    EXPECT_EQ(of.candidates.taken, 1);
    EXPECT_EQ(of.candidates.rejected, 3);
    EXPECT_EQ(of.candidates.retained.triangle, 2);  // towards +x
    const std::string text = account_text(account, small.model());
    EXPECT_NE(text.find("k p = 1000 x 0.2"), std::string::npos) << text;
    EXPECT_NE(text.find("= 200 "), std::string::npos) << text;
    EXPECT_NE(text.find("the only sub-triangle that accepts the node"), std::string::npos) << text;
    const auto json = account_json(account, small.model());
    EXPECT_NEAR(json["interfaces"][0]["force"][2].get<double>(), 200, 1e-10);
    EXPECT_TRUE(json["interfaces"][0]["replayed_to_the_last_bit"].get<bool>());
    EXPECT_EQ(json["interfaces"][0]["candidates"]["segments"][0]["triangles"].size(), 4u);
}

TEST(ExplainDeck, AGapOfZeroSaysWhyTheNodeHasNoThickness) {
    const auto text = [](SceneBuilder& small) {
        Interface& card = small.model().interfaces[0];
        card.igap = Sourced<int>{1};
        card.secondary.thickness = card.secondary.contact_thickness = {0.0};
        return account_text(explain_deck(small.scene(), {blank_id(small), 0.0, {}}), small.model());
    };
    SceneBuilder bare = resting({0.2, 0.1, 0.3});
    EXPECT_NE(text(bare).find("the node belongs to no shell"), std::string::npos) << text(bare);
    SceneBuilder covered = resting({0.2, 0.1, 0.3});
    Model& model = covered.model();
    Part part;
    part.material = static_cast<int>(model.materials.size());
    model.materials.emplace_back();  // a new material is void
    Shell shell;
    shell.part = static_cast<int>(model.parts.size());
    shell.node.fill(covered.blank_node(0));
    model.parts.push_back(part);
    model.shells.push_back(shell);
    EXPECT_NE(text(covered).find("the shells at the node are void"), std::string::npos) << text(covered);
}

TEST(ExplainDeck, EachRejectionNamesItsStepAndItsNumber) {
    const auto reason = [](const Vec3& blank, int k) {
        SceneBuilder small = resting(blank);
        const DeckAccount account = explain_deck(small.scene(), {blank_id(small), 0.0, {}});
        const SubTriangleAccount& t =
            account.interfaces.at(0).candidates.segments.at(0).triangles.at(static_cast<size_t>(k - 1));
        return std::to_string(t.step) + " " + t.reason;
    };
    EXPECT_EQ(reason({0.2, 0.1, 0.3}, 4).substr(0, 6), "2 b' =");   // towards -x: left of it
    EXPECT_EQ(reason({0.2, 0.1, 0.7}, 2), "5 d = 0.7 >= g = 0.5");  // farther than the gap
    EXPECT_EQ(reason({0.2, 0.1, 0.3}, 2), "0 d = 0.3 < g = 0.5");   // taken
    EXPECT_EQ(reason({0.2, 0.1, -1.0}, 2), "0 behind, d = 1 < DEPTH = 2");
    EXPECT_EQ(reason({1.5, 0.1, 0.3}, 2).substr(0, 13), "2 b'+c' = 1.5");  // beyond the border
}

TEST(ExplainDeck, SaysWhyThereIsNoContact) {
    SceneBuilder far = resting({0.2, 0.1, 5.0});
    EXPECT_NE(account_text(explain_deck(far.scene(), {blank_id(far), 0.0, {}}), far.model())
                  .find("no segment is near enough"),
              std::string::npos);
    SceneBuilder above = resting({0.2, 0.1, 0.7});
    EXPECT_NE(account_text(explain_deck(above.scene(), {blank_id(above), 0.0, {}}), above.model())
                  .find("every sub-triangle rejects"),
              std::string::npos);
    SceneBuilder later = resting({0.2, 0.1, 0.3});
    later.card().tstart.value = 0.005;
    const auto text = [&](double time) {
        return account_text(explain_deck(later.scene(), {blank_id(later), time, {}}), later.model());
    };
    EXPECT_NE(text(0.002).find("is not active at this time"), std::string::npos);
    EXPECT_EQ(text(0.008).find("is not active at this time"), std::string::npos);
    SceneBuilder off = resting({0.2, 0.1, 0.3});
    off.card().inacti.value = 1;
    EXPECT_NE(account_text(explain_deck(off.scene(), {blank_id(off), 0.0, {}}), off.model()).find("switched off"),
              std::string::npos);
}

TEST(ExplainDeck, TakesTheLastCycleThatIsNotAfterTheTime) {
    SceneBuilder small = resting({0.2, 0.1, 0.3});
    const auto cycle = [&](double time) { return explain_deck(small.scene(), {blank_id(small), time, {}}).cycle; };
    EXPECT_EQ(cycle(0.0), 0);
    EXPECT_EQ(cycle(0.0029), 2);
    EXPECT_EQ(cycle(0.003), 3) << "three steps of 0.001 add up to 0.003 but for rounding";
    EXPECT_EQ(cycle(0.01), 9) << "ten steps add up to more than the end of the run";
}

std::string error_of(SceneBuilder& small, const ExplainRequest& request) {
    try {
        explain_deck(small.scene(), request);
    } catch (const ExplainError& error) {
        return error.what();
    }
    return "";
}

TEST(ExplainDeck, WhatIsNotThereIsNamed) {
    SceneBuilder small = resting({0.2, 0.1, 0.3});
    EXPECT_NE(error_of(small, {77, 0.0, {}}).find("no node 77"), std::string::npos);
    EXPECT_NE(error_of(small, {1001, 0.0, {}}).find("node 1001 is not on the secondary side"), std::string::npos);
    EXPECT_NE(error_of(small, {blank_id(small), 0.02, {}}).find("beyond the run"), std::string::npos);
    EXPECT_NE(error_of(small, {blank_id(small), -1.0, {}}).find("negative"), std::string::npos);
    EXPECT_NE(error_of(small, {blank_id(small), 0.0, Id{9}}).find("no interface 9; it has 1"), std::string::npos);
}

TEST(ExplainDeck, AnOrdinaryNodeFitsOnOneScreen) {
    const PreparedDeck deck = prepared("cylinder_slide", "");
    const DeckAccount account = explain_deck(*deck.scene, {1014, 4e-4, {}});
    const std::string text = account_text(account, *deck.scene->host);
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 62) << text;
}

// A sub-triangle is rejected at each step of the projection (Formulation 3, steps 1 to 5), and the trace says which.
TEST(ProjectionTrace, StopsAtTheStepThatRejects) {
    using namespace reference;
    const auto step = [](const Vec3& p, const SubTriangle<double>& t, bool lands) {
        ProjectionRecord record;
        EXPECT_EQ(project<double>(p, t, {}, record).has_value(), lands);
        return record;
    };
    const Vec3 z(0, 0, 1);
    SubTriangle<double> t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, z, z, z, z};
    EXPECT_EQ(step({0.2, 0.2, 0.5}, t, true).step, 3);
    EXPECT_EQ(step({2, 2, 0.5}, t, false).step, 2);
    t.normal_b = {1, 0, -0.5};
    const ProjectionRecord leaning = step({0.2, 0.2, 0.5}, t, false);
    EXPECT_EQ(leaning.step, 1);
    EXPECT_EQ((*leaning.corner_slopes)[1], -0.5);
    EXPECT_FALSE(leaning.turn);
    // n_B = (-1, 0, 1): at height 2 the corner B' has passed A'.
    t.normal_b = {-1, 0, 1};
    const ProjectionRecord turned = step({-0.5, 0.1, 2.0}, t, false);
    EXPECT_EQ(turned.step, 2);
    EXPECT_LT(*turned.turn, 0);
    EXPECT_FALSE(turned.lifted);
    SubTriangle<double> flat = t;
    flat.area = {0, 0, 0};
    flat.normal_b = z;
    EXPECT_EQ(step({0.2, 0.2, 0.5}, flat, false).step, 2) << "a sub-triangle without area rejects at 2";
}

}  // namespace
}  // namespace type21
