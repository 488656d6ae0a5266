#include <numeric>

#include <gtest/gtest.h>

#include "verification/performance/accuracy/measure.h"

namespace type21::accuracy {
namespace {

constexpr size_t count = 672;  // one block of each family
constexpr double no_limit = 1e9;

/// A scene with its exact answers and all methods.
struct Bench {
    explicit Bench(const char* name, size_t decisions = count)
        : blocks(scene_named(name)->make(decisions, 1)), asked(all_asked(blocks)), order(asked.size()) {
        for (const Asked& one : asked)
            truths.push_back(truth_of(one.tool(), one.query()));
        std::iota(order.begin(), order.end(), size_t{0});
    }
    Score of(const Method& method) const { return score(method, truths, order, no_limit); }

    std::vector<QuestionBlock> blocks;
    std::vector<Asked> asked;
    std::vector<Truth> truths;
    std::vector<size_t> order;
};

const Method& named(const std::vector<Method>& methods, const std::string& name) {
    for (const Method& method : methods)
        if (method.name == name) return method;
    throw std::logic_error("no method " + name);
}

TEST(Methods, FloatAndDoubleGetSomeWrongOnTheAdversarialSceneAndExactOnesNone) {
    const Bench bench("adversarial");
    ASSERT_EQ(bench.asked.size(), count);
    for (const Method& method : arithmetic_methods(bench.asked)) {
        const Score result = bench.of(method);
        EXPECT_EQ(result.decisions, count);
        if (method.exact)
            EXPECT_EQ(result.wrong, 0U) << method.implementation << " " << method.name;
        else
            EXPECT_GT(result.wrong, count / 100) << method.name;
        const bool may_not_tell = method.name == "interval" || method.name == "double with bound";
        EXPECT_EQ(result.undecided > 0, may_not_tell) << method.implementation << " " << method.name;
        EXPECT_GT(result.force.judged(), 0U);
    }
}

// In units in the last place of what enters. Both let a double be where the bound of its error says at most some
// thousand of them, and a bound is more than ten times the error: a force is as good as its data. Plain doubles are
// percents off where normals meet, and anywhere where they decide wrongly.
TEST(Methods, ImplementationsAreWithinRoundingOfTheExactForceOnTheAdversarialScene) {
    const Bench bench("adversarial", 2 * count);
    const auto methods = arithmetic_methods(bench.asked);
    EXPECT_GT(bench.of(named(methods, "double")).force.scaled(1), 1e9) << "the questions are easy";
    int implementations = 0;
    for (const Method& method : methods) {
        if (method.implementation.empty()) continue;
        EXPECT_LT(bench.of(method).force.scaled(1), 64) << method.implementation;
        ++implementations;
    }
    EXPECT_EQ(implementations, 2);
}

TEST(Methods, DoubleIsWrongWhereMeshesLieOnEachOther) {
    const Bench bench("mesh_flat", 300);
    const auto methods = arithmetic_methods(bench.asked);
    EXPECT_GT(bench.of(named(methods, "double")).wrong, 10U);
    EXPECT_GT(bench.of(named(methods, "float")).force.relative(1), 1e-8);
    EXPECT_LT(bench.of(named(methods, "exact")).force.scaled(1), 4);
}

TEST(Methods, EverySearchFindsTheExactAnswer) {
    for (const SceneKind& kind : scene_kinds()) {
        const Bench bench(kind.name.data(), kind.kind == "adversarial" ? count : 60);
        size_t asked = 0;
        for (const Method& method : search_methods(bench.blocks, bench.asked)) {
            const Score result = bench.of(method);
            EXPECT_EQ(result.wrong, 0U) << kind.name << ": " << method.implementation << " " << method.name;
            asked += result.decisions;
        }
        EXPECT_EQ(asked, 6 * bench.asked.size());
    }
}

TEST(Methods, StagesAddUpToTheDecisions) {
    const Bench bench("adversarial");
    for (const Method& method : arithmetic_methods(bench.asked)) {
        if (method.stages.empty()) continue;
        const Score result = bench.of(method);
        size_t settled = 0;
        for (const auto& stage : result.settled)
            settled += stage.size();
        EXPECT_EQ(settled, count);
        EXPECT_GT(result.settled.back().size(), 0U) << "the hardest questions need the last stage";
    }
}

TEST(Score, ABrokenMethodIsCountedWrong) {
    const Bench bench("random_flat", 200);
    const auto methods = arithmetic_methods(bench.asked);
    const Method& right = named(methods, "exact");
    size_t contacts = 0;
    for (const Truth& truth : bench.truths)
        contacts += truth.answer.kind == Kind::contact ? 1 : 0;
    ASSERT_GT(contacts, 50U);

    Method broken = right;
    broken.answer = [&](size_t q) {
        Answer answer = right.answer(q);
        if (answer.kind == Kind::contact) answer.side = -answer.side;
        return answer;
    };
    EXPECT_EQ(bench.of(broken).wrong, contacts);
    broken.answer = [&](size_t) { return Answer{}; };
    EXPECT_EQ(bench.of(broken).wrong, contacts);
    EXPECT_EQ(bench.of(broken).force.relative(0), 1) << "it finds no force where there is one";
    broken.answer = [&](size_t q) {
        Answer answer = right.answer(q);
        answer.penetration *= 1.5;
        return answer;
    };
    EXPECT_EQ(bench.of(broken).wrong, 0U);
    EXPECT_NEAR(bench.of(broken).force.relative(0), 0.5, 1e-9);
    broken.answer = [&](size_t) { return Answer{Kind::contact, 0, 1, 1, 0.1}; };
    EXPECT_GT(bench.of(broken).force.spurious(), 0U) << "a force where there is none";
    broken.answer = [](size_t) {
        Answer answer;
        answer.undecided = true;
        return answer;
    };
    EXPECT_EQ(bench.of(broken).wrong, 0U);
    EXPECT_EQ(bench.of(broken).undecided, 200U);
}

TEST(Score, AWrongMethodThatPromisesToBeExactSpoilsTheResult) {
    Result result;
    result.rows.resize(2);
    result.rows[0].score.wrong = 1;
    EXPECT_TRUE(result.exact_ones_are_right()) << "it promises nothing";
    result.rows[1].exact = true;
    EXPECT_TRUE(result.exact_ones_are_right());
    result.rows[1].score.wrong = 1;
    EXPECT_FALSE(result.exact_ones_are_right());
}

TEST(Score, StopsWhenItsTimeIsOver) {
    const Bench bench("random_flat", 200);
    const auto methods = arithmetic_methods(bench.asked);
    const Score result = score(named(methods, "exact"), bench.truths, bench.order, 0);
    EXPECT_EQ(result.decisions, 16U);
}

}  // namespace
}  // namespace type21::accuracy
