#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "reference/cycle/contact.h"
#include "verification/performance/bench/bench.h"
#include "verification/performance/bench/closest_point.h"
#include "verification/performance/bench/exact_decisions.h"

namespace type21::bench {
namespace {

TEST(TimingSpread, IsOfSortedNumbers) {
    const TimingSpread s = timing_spread({5, 1, 4, 2, 3});
    EXPECT_EQ(s.min, 1);
    EXPECT_EQ(s.p50, 3);
    EXPECT_EQ(s.p95, 5);
    EXPECT_EQ(s.max, 5);
    EXPECT_THROW(timing_spread({}), std::invalid_argument);
}

TEST(Rounds, RunInTurnAndCompareMedians) {
    std::string order;
    Rounds rounds;
    rounds.add("a", [&] {
        order += 'a';
        return 10.0;
    });
    rounds.add(
        "b",
        [&] {
            order += 'b';
            return 5.0;
        },
        2);
    rounds.add(
        "c",
        [&] {
            order += 'c';
            return 1.0;
        },
        -2);
    rounds.run(3);
    EXPECT_EQ(order, "abbabbcabbabbc") << "a round to warm up, then three; the slow one in every other";
    EXPECT_EQ(rounds.of_medians("a", "b"), 2);
    EXPECT_EQ(rounds.of_minima("b", "c"), 5);
    EXPECT_TRUE(rounds.has("c"));
    EXPECT_FALSE(rounds.has("d"));
    EXPECT_THROW(rounds.of("d"), std::invalid_argument);
}

TEST(Target, IsReachedOnItsOwnSide) {
    Target faster{"", "", "x", Better::higher, 10, 20, 9.99, ""};
    EXPECT_EQ(faster.reached(), "no");
    faster.measured = 10;
    EXPECT_EQ(faster.reached(), "at least");
    faster.measured = 20;
    EXPECT_EQ(faster.reached(), "aim");
    Target cost{"", "", "x", Better::lower, 1.1, 1.02, 1.11, ""};
    EXPECT_EQ(cost.reached(), "no");
    cost.measured = 1.1;
    EXPECT_EQ(cost.reached(), "at least");
    cost.measured = 1.0;
    EXPECT_EQ(cost.reached(), "aim");
    cost.measured = std::nan("");
    EXPECT_EQ(cost.reached(), "no");
}

TEST(Target, TableShowsNumbersAndVerdict) {
    const std::string text = to_text({{"coherent step", "pan", "x", Better::higher, 10, 20, 12.5, "busy machine"}});
    EXPECT_NE(text.find("coherent step"), std::string::npos);
    EXPECT_NE(text.find("10 x      20 x     12.5 x  at least (busy machine)"), std::string::npos) << text;
    EXPECT_EQ(to_text(std::vector<Target>{}), "");
}

TEST(Counts, HaveSuffixesAndLimits) {
    EXPECT_EQ(count_of("20k", 1, 1000000), 20000);
    EXPECT_EQ(count_of("1M", 1, 1000000), 1000000);
    EXPECT_EQ(count_of("17", 1, 1000000), 17);
    for (const char* word : {"", "k", "-5", "20kk", "1.5M", "2M", "0", "99999999999"})
        EXPECT_THROW(count_of(word, 1, 1000000), std::invalid_argument) << word;
    EXPECT_EQ(short_count(200000), "200k");
    EXPECT_EQ(short_count(3000000), "3M");
    EXPECT_EQ(short_count(0), "0");
    EXPECT_EQ(short_count(1234), "1234");
}

TEST(Scenes, AreWhatTheirNamesSay) {
    const BenchScene pan = pan_bench("pan", 20000, 5000);
    EXPECT_NEAR(static_cast<double>(pan.segments().size()), 20000, 200);
    EXPECT_EQ(pan.nodes(), 5000U);
    EXPECT_EQ(pan.sub_triangles(), pan.segments().size());
    const std::vector<Decision> pan_truth = ExactDecisions(pan).at(pan.motion(0));
    long taken = 0;
    for (const Decision& d : pan_truth)
        taken += d.kind == Kind::contact;
    EXPECT_GT(taken, 4950) << "nodes lie within 1.9 mm, the gap is 2 mm";

    const BenchScene ties = ties_bench(8);
    EXPECT_EQ(ties.nodes(), 225U);
    EXPECT_EQ(ties.sub_triangles(), 256U);
    // Over the corner that squares 0, 1, 8, 9 share: all tie, the lowest wins.
    const std::vector<Decision> truth = ExactDecisions(ties).at(ties.motion(3));
    EXPECT_EQ(truth[15 + 1].segment, 0);
    EXPECT_EQ(truth[15 + 1].triangle, 2);

    const BenchScene bowl = bowl_bench();
    EXPECT_EQ(bowl.nodes(), 100489U);
    EXPECT_EQ(bowl.segments().size(), 48400U);
    EXPECT_NEAR((bowl.motion(2).tools[0].position - bowl.motion(1).tools[0].position).norm(), 0.002, 1e-15);
}

/// The reference, but for one node in one cycle.
class OneWrong final : public ContactMethod {
  public:
    OneWrong(const Scene& scene, int interface) : right_(scene, interface) {}
    ContactStep step(const Motion& motion) override {
        ContactStep step = right_.step(motion);
        if (++cycle_ == 2) ++step.nodes[7].decision.segment;
        return step;
    }
    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& x) const override {
        return right_.initial_penetrations(x);
    }
    std::vector<EffectMemory> memory_by_effect() const override { return right_.memory_by_effect(); }
    DecisionStageCounts decision_stage_counts() const override { return right_.decision_stage_counts(); }

  private:
    reference::Contact right_;
    int cycle_ = 0;
};

TEST(Check, SeesAWrongDecision) {
    const BenchScene scene = ties_bench(6);
    const CheckPart good = check_steps(scene, 2000);
    EXPECT_EQ(good.different, 0) << good.first_difference;
    EXPECT_EQ(good.decisions, 2000);
    const CheckPart bad =
        check_steps(scene, 2000, [](const Scene& s, int i) { return std::make_unique<OneWrong>(s, i); });
    EXPECT_EQ(bad.different, 1);
    EXPECT_NE(bad.first_difference.find("ties, node 8, cycle 2: contact, segment "), std::string::npos)
        << bad.first_difference;
    Decision one, other;
    EXPECT_TRUE(same(one, other));
    one.kind = Kind::contact;
    EXPECT_FALSE(same(one, other));
    other = one;
    other.side = -1;
    EXPECT_FALSE(same(one, other));
    EXPECT_EQ(in_words(other), "contact, segment -1, triangle 0, side -1");
}

/// All of a bench of small scenes, once.
const BenchResult& small_bench() {
    static const BenchResult result = [] {
        BenchOptions options;
        options.sizes = {1000, 2000};
        options.nodes = {500};
        options.quick = true;
        options.check = 3000;
        options.blank = 32;
        options.tool = 22;
        options.ties = 16;
        options.usual_nodes = 1000;
        BenchResult found = run_bench(options);
        found.command = "type21 bench";
        return found;
    }();
    return result;
}

TEST(Bench, FindsNoWrongDecisionOfTheExact) {
    const BenchResult& result = small_bench();
    EXPECT_EQ(result.different(), 0);
    EXPECT_GT(result.decisions(), 2500);
    EXPECT_EQ(result.check.size(), 6U);
    for (const MethodRow& row : result.rows) {
        const bool exact = row.implementation == "optimized" || row.implementation == "reference";
        EXPECT_TRUE(row.wrong == 0 || !exact) << row.scene << row.method;
        EXPECT_GT(row.decisions, 0);
        EXPECT_GT(row.ns.min, 0);
        EXPECT_LE(row.ns.min, row.ns.p50);
        EXPECT_LE(row.ns.p95, row.ns.max);
    }
}

TEST(Bench, JsonHasEveryPart) {
    const nlohmann::ordered_json json = to_json(small_bench());
    for (const char* key : {"format", "command",  "version", "commit",   "cpu",   "compiler", "flags",  "repeats",
                            "quick",  "seconds",  "machine", "scenes",   "rows",  "ratios",   "stages", "effects",
                            "growth", "searches", "threads", "roofline", "check", "targets"})
        EXPECT_TRUE(json.contains(key)) << key;
    std::set<std::string> scenes, implementations;
    for (const auto& row : json["rows"]) {
        scenes.insert(row["scene"]);
        implementations.insert(row["implementation"]);
    }
    EXPECT_EQ(scenes, (std::set<std::string>{"bowl", "ties", "pan_1k", "pan_1k_sheet", "pan_1k_500_nodes", "pan_2k",
                                             "pan_2k_sheet", "pan_2k_500_nodes"}));
    std::set<std::string> expected{"optimized", "plain double", "reference", "CGAL AABB tree", "candidate list"};
    if (has_embree()) expected.insert("Embree");
    EXPECT_EQ(implementations, expected);
    EXPECT_EQ(json["effects"].size(), 13U);
    EXPECT_EQ(json["threads"].size(), 2U);
    EXPECT_EQ(json["searches"].size(), 3U * 6U);
    for (size_t i = 1; i < 6; ++i) {
        const auto &one = json["searches"][i], &before = json["searches"][i - 1];
        EXPECT_EQ(one["search"], "sorted");
        EXPECT_GE(one["candidates_per_node"], one["boxes_per_node"]);
        EXPECT_GE(one["ns_in_all"], one["ns"]);
        if (i == 1) continue;
        EXPECT_GE(one["candidates_per_node"], before["candidates_per_node"]);
        EXPECT_GT(one["cycles_per_sort"], before["cycles_per_sort"]);
    }
    EXPECT_TRUE(json["threads"][1]["same_bits"]);
    EXPECT_EQ(json["growth"].size(), 4U);
    double shares = 0;
    for (const auto& [path, share] : json["scenes"][0]["paths"].items())
        shares += share.get<double>();
    EXPECT_NEAR(shares, 1, 1e-12);
    for (const auto& target : json["targets"])
        EXPECT_TRUE(target["reached"] == "no" || target["reached"] == "at least" || target["reached"] == "aim");
    EXPECT_EQ(json.dump().find("null"), std::string::npos);
}

TEST(Bench, JsonRefusesWhatIsNoNumber) {
    BenchResult result = small_bench();
    result.stages[0].ns = std::nan("");
    EXPECT_THROW(to_json(result), std::runtime_error);
}

TEST(Bench, TextShowsEveryPart) {
    const std::string text = to_text(small_bench());
    for (const char* part :
         {"stages of the coherent step", "Coulomb friction", "growth", "2 threads", "decisions, 0 differ", "at least",
          "candidate list, step", "B per segment", "cycles/sort", "with the sorted search"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace type21::bench
