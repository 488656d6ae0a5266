// The long runs in short: the same scenes and the same bounds, which shrink with the number of cycles.
#include <cmath>
#include <memory>
#include <tuple>

#include <gtest/gtest.h>

#include "reference/cycle/contact.h"
#include "verification/stability/long_runs.h"
#include "verification/stability/stability_report.h"
#include "verification/support/contact_choice.h"

namespace type21::stability {
namespace {

constexpr long short_run = 10000;

/// Both implementations keep the bounds.
class LongRuns : public ::testing::TestWithParam<std::tuple<std::string, LongRunKind>> {};

TEST_P(LongRuns, HoldInShort) {
    const auto& [with, kind] = GetParam();
    const LongRun run = kind.run(contact_maker(with), short_run);
    EXPECT_EQ(run.name, kind.name);
    EXPECT_TRUE(run.holds()) << to_text(run);
    int bounds = 0;
    for (const Finding& finding : run.findings)
        bounds += finding.has_bound() ? 1 : 0;
    EXPECT_GE(bounds, 4) << "a run without bounds shows nothing";
}

INSTANTIATE_TEST_SUITE_P(All, LongRuns,
                         ::testing::Combine(::testing::ValuesIn(contact_choices()), ::testing::ValuesIn(long_runs())),
                         [](const auto& tested) {
                             return fmt::format("{}_{}", std::get<0>(tested.param), std::get<1>(tested.param).name);
                         });

/// The reference with an error that grows with time: a long run has to find it.
class Drifting final : public ContactMethod {
  public:
    Drifting(const Scene& scene, int i, double growth) : contact_(scene, i), growth_(growth) {}
    ContactStep step(const Motion& motion) override {
        ContactStep step = contact_.step(motion);
        for (NodeContact& node : step.nodes) {
            const double error = 1.0 + growth_ * static_cast<double>(cycle_);
            node.normal_force *= error;
            node.friction *= error;
            node.force *= error;
        }
        ++cycle_;
        return step;
    }
    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& x) const override {
        return contact_.initial_penetrations(x);
    }
    std::vector<EffectMemory> memory_by_effect() const override { return contact_.memory_by_effect(); }
    DecisionStageCounts decision_stage_counts() const override { return contact_.decision_stage_counts(); }

  private:
    reference::Contact contact_;
    double growth_;
    long cycle_ = 0;
};

class DriftingRuns : public ::testing::TestWithParam<LongRunKind> {};

INSTANTIATE_TEST_SUITE_P(All, DriftingRuns, ::testing::ValuesIn(long_runs()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_P(DriftingRuns, AreFound) {
    // 1e-7 of the force a cycle: 1e-3 at the end. A bounce sees only what changes while it lasts, 157 cycles: undamped
    // it is asked for 1/4 (omega dt)^2 = 1e-4 of the energy; damped for 4 zeta omega dt = 6e-3.
    const std::string_view name = GetParam().name;
    const double growth = name == "bounce" ? 1e-5 : name == "bounce_damped" ? 1e-4 : 1e-7;
    const MakeContact drifting = [growth](const Scene& scene, int i) {
        return std::make_unique<Drifting>(scene, i, growth);
    };
    EXPECT_FALSE(GetParam().run(drifting, short_run).holds());
}

TEST(Finding, DoesNotHoldForNaN) {
    Finding finding{"x", 0.0, "N", -HUGE_VAL, HUGE_VAL, ""};
    EXPECT_TRUE(finding.holds());
    EXPECT_FALSE(finding.has_bound());
    finding.value = std::nan("");
    EXPECT_FALSE(finding.holds());
    EXPECT_FALSE(LongRun{}.holds()) << "a run without a finding has shown nothing";
}

}  // namespace
}  // namespace type21::stability
