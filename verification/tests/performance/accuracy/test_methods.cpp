#include <numeric>

#include <gtest/gtest.h>

#include "verification/performance/accuracy/measure.h"

namespace type21::accuracy {
namespace {

constexpr size_t count = 672;  // one block of each question family
constexpr double no_limit = 1e9;

/// A scene with its exact answers.
struct AnsweredScene {
    explicit AnsweredScene(const char* name, size_t decisions = count)
        : blocks(scene_named(name)->make(decisions, 1)), queries(all_queries(blocks)), order(queries.size()) {
        for (const BlockQuery& one : queries)
            exact.push_back(exact_answer_of(one.tool(), one.query()));
        std::iota(order.begin(), order.end(), size_t{0});
    }
    Score of(const Method& method) const { return score(method, exact, order, no_limit); }

    std::vector<QueryBlock> blocks;
    std::vector<BlockQuery> queries;
    std::vector<ExactAnswer> exact;
    std::vector<size_t> order;
};

const Method& named(const std::vector<Method>& methods, const std::string& name) {
    for (const Method& method : methods)
        if (method.name == name) return method;
    throw std::logic_error("no method " + name);
}

TEST(Methods, FloatAndDoubleGetSomeWrongOnTheAdversarialSceneAndExactOnesNone) {
    const AnsweredScene scene("adversarial");
    ASSERT_EQ(scene.queries.size(), count);
    for (const Method& method : arithmetic_methods(scene.queries)) {
        const Score result = scene.of(method);
        EXPECT_EQ(result.decisions, count);
        if (method.exact)
            EXPECT_EQ(result.wrong, 0U) << method.implementation << " " << method.name;
        else
            EXPECT_GT(result.wrong, count / 100) << method.name;
        const bool may_not_tell = method.name == "interval" || method.name == "double with bound";
        EXPECT_EQ(result.undecided > 0, may_not_tell) << method.implementation << " " << method.name;
        EXPECT_GT(result.force.compared(), 0U);
    }
}

// In units in the last place of what enters. Both let a double be where the bound of its error says at most some
// thousand of them, and a bound is more than ten times the error: a force is as good as its data. Plain doubles are
// percents off where normals meet, and anywhere where they decide wrongly.
TEST(Methods, ImplementationsAreWithinRoundingOfTheExactForceOnTheAdversarialScene) {
    const AnsweredScene scene("adversarial", 2 * count);
    const auto methods = arithmetic_methods(scene.queries);
    EXPECT_GT(scene.of(named(methods, "double")).force.scaled(1), 1e9) << "the queries are easy";
    int implementations = 0;
    for (const Method& method : methods) {
        if (method.implementation.empty()) continue;
        EXPECT_LT(scene.of(method).force.scaled(1), 64) << method.implementation;
        ++implementations;
    }
    EXPECT_EQ(implementations, 2);
}

TEST(Methods, DoubleIsWrongWhereMeshesLieOnEachOther) {
    const AnsweredScene scene("mesh_flat", 300);
    const auto methods = arithmetic_methods(scene.queries);
    EXPECT_GT(scene.of(named(methods, "double")).wrong, 10U);
    EXPECT_GT(scene.of(named(methods, "float")).force.relative(1), 1e-8);
    EXPECT_LT(scene.of(named(methods, "exact")).force.scaled(1), 4);
}

TEST(Methods, EverySearchFindsTheExactAnswer) {
    for (const SceneKind& kind : scene_kinds()) {
        const AnsweredScene scene(kind.name.data(), kind.kind == "adversarial" ? count : 60);
        size_t decisions = 0;
        for (const Method& method : search_methods(scene.blocks, scene.queries)) {
            const Score result = scene.of(method);
            EXPECT_EQ(result.wrong, 0U) << kind.name << ": " << method.implementation << " " << method.name;
            decisions += result.decisions;
        }
        EXPECT_EQ(decisions, 6 * scene.queries.size());
    }
}

TEST(Methods, StagesAddUpToTheDecisions) {
    const AnsweredScene scene("adversarial");
    for (const Method& method : arithmetic_methods(scene.queries)) {
        if (method.stages.empty()) continue;
        const Score result = scene.of(method);
        size_t settled = 0;
        for (const auto& stage : result.settled)
            settled += stage.size();
        EXPECT_EQ(settled, count);
        EXPECT_GT(result.settled.back().size(), 0U) << "the hardest queries need the last stage";
    }
}

TEST(Score, ABrokenMethodIsCountedWrong) {
    const AnsweredScene scene("random_flat", 200);
    const auto methods = arithmetic_methods(scene.queries);
    const Method& right = named(methods, "exact");
    size_t contacts = 0;
    for (const ExactAnswer& exact : scene.exact)
        contacts += exact.answer.kind == Kind::contact ? 1 : 0;
    ASSERT_GT(contacts, 50U);

    Method broken = right;
    broken.answer = [&](size_t q) {
        Answer answer = right.answer(q);
        if (answer.kind == Kind::contact) answer.side = -answer.side;
        return answer;
    };
    EXPECT_EQ(scene.of(broken).wrong, contacts);
    broken.answer = [&](size_t) { return Answer{}; };
    EXPECT_EQ(scene.of(broken).wrong, contacts);
    EXPECT_EQ(scene.of(broken).force.relative(0), 1) << "it finds no force where there is one";
    broken.answer = [&](size_t q) {
        Answer answer = right.answer(q);
        answer.penetration *= 1.5;
        return answer;
    };
    EXPECT_EQ(scene.of(broken).wrong, 0U);
    EXPECT_NEAR(scene.of(broken).force.relative(0), 0.5, 1e-9);
    broken.answer = [&](size_t) { return Answer{Kind::contact, 0, 1, 1, 0.1}; };
    EXPECT_GT(scene.of(broken).force.spurious(), 0U) << "a force where there is none";
    broken.answer = [](size_t) {
        Answer answer;
        answer.undecided = true;
        return answer;
    };
    EXPECT_EQ(scene.of(broken).wrong, 0U);
    EXPECT_EQ(scene.of(broken).undecided, 200U);
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
    const AnsweredScene scene("random_flat", 200);
    const auto methods = arithmetic_methods(scene.queries);
    const Score result = score(named(methods, "exact"), scene.exact, scene.order, 0);
    EXPECT_EQ(result.decisions, 16U);
}

}  // namespace
}  // namespace type21::accuracy
