// Reference and optimized side by side over all cases; and that the comparison sees what is wrong.
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "reference/host/prepare_deck.h"
#include "verification/criteria/cases/verify_cases.h"
#include "verification/criteria/lockstep/lockstep_report.h"
#include "verification/support/contact_choice.h"

namespace type21 {
namespace {

std::vector<Case> all_cases() {
    std::vector<std::string> problems;
    std::vector<Case> cases = read_cases(std::filesystem::path(TYPE21_SOURCE_DIR) / "cases", {}, problems);
    EXPECT_TRUE(problems.empty());
    return cases;
}

void expect_all_the_same(const std::string& as_built, const std::string& search = "") {
    const auto records = lockstep_decks(lockstep_targets(all_cases(), as_built), {2, {}, {}, search});
    LockstepResult all;
    for (const LockstepRecord& record : records) {
        if (record.refused) continue;
        EXPECT_TRUE(record.ok()) << to_text({record});
        all += record.result;
    }
    EXPECT_EQ(all.different, 0);
    EXPECT_GT(all.in_contact, 100000);
    EXPECT_GT(all.in_contact, 1000 * all.grazing);
}

TEST(Lockstep, AllCasesAsDocumented) {
    expect_all_the_same("none");
}

TEST(Lockstep, AllCasesAsBuilt) {
    expect_all_the_same("all");
}

TEST(Lockstep, AllCasesWithTheSortedSearch) {
    expect_all_the_same("none", "sorted");
}

TEST(Lockstep, AllCasesAsBuiltWithTheSortedSearch) {
    expect_all_the_same("all", "sorted");
}

/// The reference, spoilt after each step.
class Spoilt final : public ContactMethod {
  public:
    using Spoil = std::function<void(ContactStep&, long cycle)>;
    Spoilt(std::unique_ptr<ContactMethod> inner, Spoil spoil) : inner_(std::move(inner)), spoil_(std::move(spoil)) {}
    ContactStep step(const Motion& motion) override {
        ContactStep step = inner_->step(motion);
        spoil_(step, cycle_++);
        return step;
    }
    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override {
        return inner_->initial_penetrations(position);
    }
    std::vector<EffectMemory> memory_by_effect() const override { return inner_->memory_by_effect(); }
    DecisionStageCounts decision_stage_counts() const override { return inner_->decision_stage_counts(); }

  private:
    std::unique_ptr<ContactMethod> inner_;
    Spoil spoil_;
    long cycle_ = 0;
};

LockstepResult against_spoilt(const std::string& name, Spoilt::Spoil spoil) {
    const std::filesystem::path deck = std::filesystem::path(TYPE21_SOURCE_DIR) / "cases" / name / (name + "_0000.rad");
    const PreparedDeck prepared = prepare_deck(deck.string(), "", true);
    const MakeContact reference = contact_maker("reference");
    return lockstep(*prepared.scene, {}, reference,
                    [&](const Scene& s, int i) { return std::make_unique<Spoilt>(reference(s, i), spoil); });
}

TEST(LockstepSees, NothingWhereNothingIsWrong) {
    const LockstepResult result = against_spoilt("fric0_table", [](ContactStep&, long) {});
    EXPECT_TRUE(result.ok());
    EXPECT_EQ(result.largest(), 0);
    EXPECT_GT(result.in_contact, 0);
}

TEST(LockstepSees, OneOtherDecision) {
    const LockstepResult result = against_spoilt("fric0_table", [](ContactStep& step, long cycle) {
        if (cycle == 100) step.nodes[3].decision.triangle += 1;
    });
    EXPECT_FALSE(result.ok());
    EXPECT_EQ(result.different, 1);
    ASSERT_TRUE(result.first_decision);
    EXPECT_EQ(result.first_decision->place.cycle, 100);
    EXPECT_EQ(result.largest(), 0);
}

TEST(LockstepSees, AForceThatIsOffByAMillionth) {
    const LockstepResult result = against_spoilt("fric0_table", [](ContactStep& step, long cycle) {
        if (cycle == 200 && step.nodes[3].status != Status::open) step.nodes[3].force *= 1 + 1e-6;
    });
    EXPECT_TRUE(result.same_decisions());
    EXPECT_FALSE(result.ok());
    ASSERT_TRUE(result.first_force);
    EXPECT_EQ(result.first_force->place.cycle, 200);
    EXPECT_GT(result.largest(), lockstep_ulps);
}

TEST(LockstepSees, ASumThatMissesANode) {
    const LockstepResult result =
        against_spoilt("fric0_table", [](ContactStep& step, long) { step.sums.normal += 1e-6 * step.sums.normal; });
    EXPECT_FALSE(result.ok());
}

TEST(LockstepSees, NaN) {
    const LockstepResult result = against_spoilt("fric0_table", [](ContactStep& step, long cycle) {
        if (cycle == 200) step.sums.elastic_energy = std::numeric_limits<double>::quiet_NaN();
    });
    EXPECT_TRUE(std::isinf(result.largest()));
    EXPECT_FALSE(result.ok());
}

TEST(UlpTally, PercentilesAndTheLargest) {
    UlpTally tally("force");
    for (int i = 1; i <= 100; ++i)
        tally.add(i * 0.25 * ulp_of_one, 1.0, {i, 0, 1, 1});
    EXPECT_EQ(tally.compared(), 100);
    EXPECT_EQ(tally.equal(), 0);
    EXPECT_EQ(tally.largest(), 25);
    EXPECT_EQ(tally.where().cycle, 100);
    // 99 of 100 are 24.75 or less; the bins are 1/16 wide.
    EXPECT_NEAR(tally.percentile(0.99), 24.75, 1.0 / 16);
    tally.add(0, 0, {});
    EXPECT_EQ(tally.equal(), 1);
    tally.add(1, 0, {});
    EXPECT_TRUE(std::isinf(tally.largest()));
}

}  // namespace
}  // namespace type21
