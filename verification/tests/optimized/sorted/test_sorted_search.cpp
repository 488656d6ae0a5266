// The sorted search against the tree and the reference: the same impacts, the same bits, and new lists when needed.
#include <bit>
#include <cstring>
#include <random>
#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include "optimized/contact.h"
#include "optimized/search/sorted/query_by_search.h"
#include "optimized/search/sorted/sort_margin.h"
#include "reference/cycle/contact.h"
#include "reference/deck/deck.h"
#include "reference/host/march.h"
#include "reference/model/resolve.h"
#include "verification/support/scene_builder.h"

namespace type21 {
namespace {

using optimized::SearchKind;

/// A number as its bits; all NaNs are one.
std::uint64_t bits(double x) {
    return std::isnan(x) ? ~0ULL : std::bit_cast<std::uint64_t>(x);
}

/// Every number of a step but the stage of a decision: a certificate needs less arithmetic than a search.
std::vector<std::uint64_t> numbers(const ContactStep& step) {
    std::vector<std::uint64_t> all;
    const auto add = [&](double x) { all.push_back(bits(x)); };
    const auto add_vector = [&](const Vec3& v) {
        for (int i = 0; i < 3; ++i)
            add(v[i]);
    };
    for (const NodeContact& node : step.nodes) {
        const Decision& d = node.decision;
        for (const int i : {static_cast<int>(d.kind), d.segment, d.triangle, d.side, static_cast<int>(node.status)})
            all.push_back(static_cast<std::uint64_t>(i));
        for (const double x : {d.b, d.c, node.gap, node.distance, node.penetration, node.offset, node.stiffness,
                               node.normal_force, node.elastic_energy, node.step_stiffness})
            add(x);
        for (const Vec3* v : {&node.normal, &node.point, &node.force, &node.friction})
            add_vector(*v);
    }
    for (const NodeHeat& node : step.heat)
        for (const double x : {node.heat, node.friction_heat, node.conductance, node.radiant_conductance})
            add(x);
    for (const double x : step.skid)
        add(x);
    for (const Vec3* v : {&step.sums.normal, &step.sums.tangential, &step.tool.force, &step.tool.moment})
        add_vector(*v);
    add(step.sums.elastic_energy);
    add(step.sums.heat_to_blank);
    return all;
}

/// What happened in a run with both searches.
struct Comparison {
    long cycles = 0, in_contact = 0;
    long different = 0;      ///< cycles in which a number of the sorted search is not that of the tree
    long not_reference = 0;  ///< decisions of nodes that are not those of the reference
    optimized::SortedSearchCounts sorted;
};

bool same(const Decision& one, const Decision& other) {
    return one.kind == other.kind && one.segment == other.segment && one.triangle == other.triangle &&
           one.side == other.side;
}

/// Steps with both searches, and with the reference where asked; the march goes on with the sorted search.
class Both final : public ContactMethod {
  public:
    Both(const Scene& scene, int interface, Comparison& result, bool with_reference)
        : tree_(scene, interface), sorted_(scene, interface, {SearchKind::sorted}), result_(result) {
        if (with_reference) reference_ = std::make_unique<reference::Contact>(scene, interface);
    }
    ContactStep step(const Motion& motion) override {
        const ContactStep tree = tree_.step(motion);
        ContactStep sorted = sorted_.step(motion);
        ++result_.cycles;
        result_.different += numbers(tree) != numbers(sorted);
        for (const NodeContact& node : sorted.nodes)
            result_.in_contact += node.decision.kind == Kind::contact;
        result_.sorted = *sorted_.sorted_search();
        if (reference_) {
            const ContactStep expected = reference_->step(motion);
            for (size_t i = 0; i < sorted.nodes.size(); ++i)
                result_.not_reference += !same(expected.nodes[i].decision, sorted.nodes[i].decision);
        }
        return sorted;
    }
    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override {
        const auto tree = tree_.initial_penetrations(position), sorted = sorted_.initial_penetrations(position);
        EXPECT_EQ(tree.size(), sorted.size());
        for (size_t i = 0; i < std::min(tree.size(), sorted.size()); ++i) {
            EXPECT_EQ(tree[i].node, sorted[i].node);
            EXPECT_EQ(tree[i].segment, sorted[i].segment);
            EXPECT_EQ(tree[i].penetration, sorted[i].penetration);
        }
        return sorted;
    }
    std::vector<EffectMemory> memory_by_effect() const override { return sorted_.memory_by_effect(); }
    DecisionStageCounts decision_stage_counts() const override { return sorted_.decision_stage_counts(); }

  private:
    optimized::Contact tree_, sorted_;
    std::unique_ptr<reference::Contact> reference_;
    Comparison& result_;
};

/// @param bumult  0: that of the deck
HostScene scene_of(const std::string& name, double bumult, const AsBuilt& as_built = {}) {
    Problems problems;
    const Deck deck = read_deck(TYPE21_SOURCE_DIR "/cases/" + name + "/" + name + "_0000.rad", problems);
    Model model = resolve(deck, as_built, problems);
    EXPECT_FALSE(problems.has_errors());
    for (Interface& interface : model.interfaces)
        if (bumult > 0) interface.bumult.value = bumult;
    return plan(std::make_shared<const Model>(std::move(model)));
}

Comparison march_both(const HostScene& scene) {
    Comparison result;
    march(
        scene, [&](const Scene& s, int i) { return std::make_unique<Both>(s, i, result, false); },
        [](const CycleRecord&) {});
    return result;
}

class SortedSearch : public ::testing::TestWithParam<const char*> {};

// Turning tools, a gap that grows, heat over a distance, nodes that begin inside, a mesh right above a mesh.
TEST_P(SortedSearch, GivesTheBitsOfTheTree) {
    long sorts = 0;
    for (const double bumult : {1e-9, 0.2, 0.4, 1e3}) {
        const Comparison c = march_both(scene_of(GetParam(), bumult));
        EXPECT_GT(c.in_contact, 0);
        EXPECT_EQ(c.different, 0) << "with Bumult " << bumult;
        EXPECT_GE(c.sorted.sorts, 1);
        // A larger margin never needs more sorts.
        if (bumult > 1e-9) {
            EXPECT_LE(c.sorted.sorts, sorts);
        }
        sorts = c.sorted.sorts;
    }
    EXPECT_EQ(sorts, 1) << "a margin larger than the scene is never left";
}

INSTANTIATE_TEST_SUITE_P(Cases, SortedSearch,
                         ::testing::Values("rotating_tool", "turning_disc", "rot_bracket", "sort_origin",
                                           "igap2_fscale", "therm_rad_dist", "proximity_race", "inacti_6",
                                           "patch_curved", "large_offset"),
                         [](const auto& name) { return std::string(name.param); });

TEST(SortedSearchAsBuilt, GivesTheBitsOfTheTreeWithAllDepartures) {
    for (const char* name : {"edge_convex", "rotating_tool", "therm_rad", "narrow_ridge", "inacti_5"}) {
        const Comparison c = march_both(scene_of(name, 0, AsBuilt::all()));
        EXPECT_EQ(c.different, 0) << name;
    }
}

/// A bumpy tool of small quads with one huge one beside them, and a blank above it.
SceneBuilder bumpy_scene() {
    SurfaceMesh mesh =
        grid(24, 24, [](int i, int j) { return Vec3(i - 12, j - 12, 0.6 * std::sin(0.7 * i) * std::cos(0.5 * j)); });
    const auto first = static_cast<int>(mesh.node.size());
    for (const Vec3& corner :
         {Vec3(-400, -400, -1.5), Vec3(400, -400, -1.5), Vec3(400, 400, -1.5), Vec3(-400, 400, -1.5)})
        mesh.node.push_back(corner);
    mesh.segment.push_back({first, first + 1, first + 2, first + 3});
    std::vector<Vec3> blank;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j)
            blank.emplace_back(-9.3 + 0.97 * i, -9.1 + 0.95 * j, 0.4 + 0.02 * ((7 * i + 3 * j) % 11));
    SceneBuilder builder;
    builder.main_node({0, 0, 0}).tool(mesh).blank(blank, {0.6, 1, 1000, 1, 0});
    builder.card([](Interface& card) {
        card.depth.value = 1.2;
        card.fric.value = 0.1;
    });
    return builder;
}

/// A tool that turns by `turn` [rad] about an oblique axis and moves by `way` [length] in each cycle, its centre at
/// `center`; the nodes of the blank stay where they are relative to `center`.
Comparison turn_tool(SceneBuilder builder, double turn, const Vec3& way, const Vec3& center, int cycles,
                     bool with_reference = true) {
    const HostScene scene = builder.scene();
    Comparison result;
    Both contact(scene, 0, result, with_reference);
    std::vector<Vec3> position = scene.model->nodes.position, velocity(position.size(), Vec3::Zero());
    for (Vec3& x : position)
        x += center;
    Motion motion;
    motion.position = position;
    motion.velocity = velocity;
    motion.tools.resize(1);
    for (int cycle = 0; cycle < cycles; ++cycle) {
        motion.time = 1e-3 * cycle;
        motion.step = motion.friction_step = cycle == 0 ? 0 : 1e-3;
        motion.tools[0].position = center + way * cycle;
        motion.tools[0].rotation = Eigen::AngleAxisd(turn * cycle, Vec3(0.1, -0.2, 1).normalized()).toRotationMatrix();
        contact.step(motion);
    }
    return result;
}

TEST(SortedSearchTurning, FindsWhatTheTreeAndTheReferenceFind) {
    for (const double turn : {1e-4, 0.02, 0.7, 3.1}) {
        for (const Vec3& center : {Vec3(0, 0, 0), Vec3(3e5, -2e5, 1e5)}) {
            const Comparison c = turn_tool(bumpy_scene(), turn, {1e-3, 5e-4, -2e-4}, center, 12);
            EXPECT_GT(c.in_contact, 1000);
            EXPECT_EQ(c.different, 0) << turn;
            EXPECT_EQ(c.not_reference, 0) << turn;
        }
    }
}

// A pure turn moves no centre. The way of the nodes in the tool frame is what counts, and the farthest move most.
TEST(SortedSearchTurning, SortsAgainBecauseOfTheTurnAlone) {
    const Comparison still = turn_tool(bumpy_scene(), 0, Vec3::Zero(), Vec3::Zero(), 50, false);
    EXPECT_EQ(still.sorted.sorts, 1);
    // The nodes reach out to 9.3: 0.01 rad move them by 0.09 a cycle, and the margin is 0.2 of 1.251 DEPTH, or of the
    // mean side, where the huge quad counts.
    const Comparison turned = turn_tool(bumpy_scene(), 0.01, Vec3::Zero(), Vec3::Zero(), 50, false);
    EXPECT_GT(turned.sorted.sorts, 1);
    EXPECT_LT(turned.sorted.sorts, 50);
    EXPECT_EQ(turned.different, 0);
}

// The sheet becomes thicker, so the gap (Igap 2) outgrows what the boxes were made for, while no node moves.
// @manual field Bumult, Igap
TEST(SortedSearchGrowing, SortsAgainWhenTheGapOutgrowsTheBoxes) {
    SceneBuilder builder;
    builder.main_node({0, 0, 0}).tool(grid(8, 8, [](int i, int j) { return Vec3(i - 4, j - 4, 0); }));
    std::vector<Vec3> blank;
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i)
            blank.emplace_back(-2.1 + i, -1.9 + j, 1.5);
    Material steel;
    steel.law = MaterialLaw::elastic;  // a void shell does not carry its gap along
    steel.young = 1000;
    builder.blank(blank, {0.5, 1, 1000, 1, 1}).blank_shells(grid_segments(4, 4), 1.0, steel);
    builder.card([](Interface& card) { card.igap.value = 2; });
    const HostScene scene = builder.scene();
    Comparison result;
    Both contact(scene, 0, result, true);
    const std::vector<Vec3> position = scene.model->nodes.position, velocity(position.size(), Vec3::Zero());
    std::vector<double> thickness(scene.model->shells.size(), 1.0);
    Motion motion;
    motion.position = position;
    motion.velocity = velocity;
    motion.thickness = thickness;
    motion.tools.resize(1);
    for (int cycle = 0; cycle < 12; ++cycle) {
        for (double& t : thickness)
            t = 1 + 0.5 * cycle;  // g = 0.5 + 0.25 cycle: contact from cycle 5 on
        contact.step(motion);
        motion.time += 1e-3;
        motion.step = motion.friction_step = 1e-3;
    }
    EXPECT_EQ(result.in_contact, 25 * 7);
    EXPECT_EQ(result.different, 0);
    EXPECT_EQ(result.not_reference, 0);
    EXPECT_GT(result.sorted.sorts, 1);
}

/// One quad and one node, with a margin of 0.25: Bumult 0.125 of sides of 2.
SceneBuilder one_quad() {
    SceneBuilder builder;
    builder.main_node({0, 0, 0}).tool(grid(1, 1, [](int i, int j) { return Vec3(2 * i - 1, 2 * j - 1, 0); }));
    builder.blank({{0, 0, 0.25}}).depth(0.5);
    builder.card([](Interface& card) { card.bumult.value = 0.125; });
    return builder;
}

/// Sorts until the node has stood at each of these places in turn.
std::vector<long> sorts_along(const std::vector<double>& x) {
    const HostScene scene = one_quad().scene();
    optimized::Contact contact(scene, 0, {SearchKind::sorted});
    std::vector<Vec3> position = scene.model->nodes.position;
    const std::vector<Vec3> velocity(position.size(), Vec3::Zero());
    Motion motion;
    motion.position = position;
    motion.velocity = velocity;
    motion.tools.resize(1);
    std::vector<long> sorts;
    for (const double place : x) {
        position.back().x() = place;
        contact.step(motion);
        motion.time += 1e-3;
        motion.step = motion.friction_step = 1e-3;
        sorts.push_back(contact.sorted_search()->sorts);
    }
    EXPECT_EQ(contact.sorted_search()->margin, 0.25);
    return sorts;
}

TEST(SortedSearch, SortsAgainExactlyBeyondTheMargin) {
    EXPECT_EQ(sorts_along({0, 0.25, -0.25, 0.25}), (std::vector<long>{1, 1, 1, 1}));
    const double beyond = std::nextafter(0.25, 1.0);
    EXPECT_EQ(sorts_along({0, 0.25, beyond, 0}), (std::vector<long>{1, 1, 2, 3}));
    // A node outside of all boxes asks for nothing, however far it flies.
    EXPECT_EQ(sorts_along({0, 50, 500, 0.125, 0.5}), (std::vector<long>{1, 1, 1, 1, 2}));
}

// @manual field Bumult
TEST(SortMargin, IsBumultTimesTheLargestOfThreeLengths) {
    SceneBuilder builder = one_quad();
    const auto margin = [&](double bumult, double depth, double proximity) {
        builder.card().bumult.value = bumult;
        builder.card().depth.value = depth;
        return optimized::sort_margin(builder.model(), builder.card(), proximity);
    };
    EXPECT_EQ(margin(0.2, 0, 0), 0.2 * 2);  // no segment of the blank: the side of the tool
    EXPECT_EQ(margin(0.4, 0, 0), 0.4 * 2);
    EXPECT_EQ(margin(0.2, 8, 0), 0.2 * (1.251 * 8));
    EXPECT_EQ(margin(0.2, 8, 16), 0.2 * (1.251 * 16));
    // With segments of the blank, their mean side: a triangle has three, here 3, 4 and 5.
    SceneBuilder sheet;
    sheet.main_node({0, 0, 0}).tool(grid(1, 1, [](int i, int j) { return Vec3(i, j, 0); }));
    sheet.blank({{0, 0, 1}, {3, 0, 1}, {3, 4, 1}}).blank_segments({{0, 1, 2, 2}}).depth(0);
    EXPECT_DOUBLE_EQ(optimized::sort_margin(sheet.model(), sheet.card(), 0), 0.2 * 4);
}

TEST(SortedSearch, GivesTheSameBitsForAnyNumberOfThreads) {
    const HostScene scene = scene_of("rotating_tool", 0.2);
    std::vector<std::uint64_t> one;
    for (const size_t threads : {1U, 2U, 4U}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<std::uint64_t> all;
        march(
            scene, [](const Scene& s, int i) { return optimized::make_contact(s, i, {SearchKind::sorted}); },
            [&](const CycleRecord& record) {
                for (const ContactStep& step : *record.contacts) {
                    const auto some = numbers(step);
                    all.insert(all.end(), some.begin(), some.end());
                }
                const auto counts =
                    dynamic_cast<const optimized::Contact&>(*record.methods->front()).sorted_search().value();
                for (const long count : {counts.sorts, counts.searches, counts.candidates, counts.near})
                    all.push_back(static_cast<std::uint64_t>(count));
            });
        if (one.empty()) one = all;
        ASSERT_FALSE(one.empty());
        EXPECT_TRUE(all == one) << threads;
    }
}

TEST(SortedSearch, CountsWhatItDid) {
    const Comparison c = march_both(scene_of("cylinder_slide", 0.2));
    const optimized::SortedSearchCounts& counts = c.sorted;
    EXPECT_EQ(counts.cycles, c.cycles);
    EXPECT_GT(counts.sorts, 1);
    EXPECT_LT(counts.sorts, c.cycles / 10);
    EXPECT_GT(counts.candidates_per_node(), counts.near_per_node());
    EXPECT_GT(counts.near_per_node(), 0.5);
    EXPECT_GT(counts.bytes, 0U);
    const HostScene scene = scene_of("cylinder_slide", 0.2);
    EXPECT_FALSE(optimized::Contact(scene, 0).sorted_search().has_value());
}

// A list from the edge of the margin and a memory from another place: the answers are those of all segments.
TEST(QueryBySearch, FindsWhatAllSegmentsGive) {
    const SurfaceMesh mesh =
        grid(6, 6, [](int i, int j) { return Vec3(i - 3, j - 3, 0.4 * std::sin(1.3 * i) * std::sin(0.9 * j)); });
    const std::vector<Vec3> normals(mesh.node.size(), Vec3(0.1, -0.2, 0.95));
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> place(-3.5, 3.5), height(-1, 1);
    long found = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 p(place(random), place(random), height(random));
        const Decision all = optimized::decide_query(mesh.node, normals, mesh.segment, p, 0.4, 0.6, 0.8);
        found += all.kind != Kind::none;
        for (const SearchKind kind : {SearchKind::tree, SearchKind::sorted}) {
            const Decision by = optimized::decide_query(mesh.node, normals, mesh.segment, p, 0.4, 0.6, 0.8, kind);
            EXPECT_TRUE(same(all, by)) << p.transpose();
        }
    }
    EXPECT_GT(found, 100);
    EXPECT_THROW(
        optimized::decide_query(mesh.node, normals, {{0, 1, 2, 99}}, Vec3::Zero(), 1, 1, 0, SearchKind::sorted),
        std::invalid_argument);
}

}  // namespace
}  // namespace type21
