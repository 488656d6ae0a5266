// Any number of threads, any width of registers, and the lean step, give the same bits.
#include <cstring>
#include <random>
#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include "optimized/contact.h"
#include "optimized/simd/simd_width.h"
#include "reference/deck/deck.h"
#include "reference/host/march.h"
#include "reference/model/resolve.h"

namespace type21 {
namespace {

HostScene scene_of(const std::string& name) {
    Problems problems;
    const Deck deck = read_deck(TYPE21_SOURCE_DIR "/cases/" + name + "/" + name + "_0000.rad", problems);
    auto model = std::make_shared<const Model>(resolve(deck, {}, problems));
    EXPECT_FALSE(problems.has_errors());
    return plan(std::move(model));
}

/// All numbers of a run that sums and forces enter, and how its decisions came about.
std::vector<double> history(const HostScene& scene, int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads));
    std::vector<double> numbers;
    std::vector<const optimized::Contact*> contacts;
    march(
        scene,
        [&](const Scene& s, int i) {
            auto made = std::make_unique<optimized::Contact>(s, i);
            contacts.push_back(made.get());
            return made;
        },
        [&](const CycleRecord& record) {
            for (const ContactStep& step : *record.contacts) {
                for (const Vec3& v : {step.tool.force, step.tool.moment, step.sums.tangential, step.sums.abs_total})
                    numbers.insert(numbers.end(), v.data(), v.data() + 3);
                numbers.insert(numbers.end(),
                               {step.sums.elastic_energy, step.sums.friction_work, step.tool.step_rotation});
                for (const NodeContact& node : step.nodes) {
                    numbers.insert(numbers.end(), node.force.data(), node.force.data() + 3);
                    numbers.push_back(static_cast<double>(node.decision.stage));
                }
            }
            for (const optimized::Contact* contact : contacts) {
                const optimized::PathCounts paths = contact->paths();
                for (const long count : {paths.exclusive_region, paths.ranking_safe, paths.edge_neighbour,
                                         paths.separated, paths.searched, paths.double_double, paths.integer})
                    numbers.push_back(static_cast<double>(count));
            }
        });
    return numbers;
}

TEST(Threads, SameBitsForAnyNumber) {
    for (const char* name : {"rotating_tool", "therm_form1_heat"}) {
        const HostScene scene = scene_of(name);
        const std::vector<double> one = history(scene, 1);
        ASSERT_FALSE(one.empty());
        for (const int threads : {2, 3, 7}) {
            const std::vector<double> many = history(scene, threads);
            ASSERT_EQ(one.size(), many.size());
            EXPECT_EQ(std::memcmp(one.data(), many.data(), one.size() * sizeof(double)), 0) << name << " " << threads;
        }
    }
}

TEST(Registers, SameBitsForAnyWidth) {
    for (const char* name : {"rotating_tool", "therm_form1_heat", "cylinder_slide_mixed", "friction_pairs",
                             "igap2_pmax_itlim0", "skid_line", "ibc"}) {
        const HostScene scene = scene_of(name);
        const std::vector<double> usual = history(scene, 1);
        ASSERT_FALSE(usual.empty());
        for (const optimized::SimdWidth machine : {optimized::SimdWidth::four, optimized::SimdWidth::two}) {
            const optimized::SimdWidthCap narrow(machine);
            const std::vector<double> numbers = history(scene, 1);
            ASSERT_EQ(numbers.size(), usual.size());
            EXPECT_EQ(std::memcmp(numbers.data(), usual.data(), usual.size() * sizeof(double)), 0)
                << name << " " << static_cast<int>(machine);
        }
    }
}

/// Steps twice: full and lean.
class FullAndLean final : public ContactMethod {
  public:
    FullAndLean(const Scene& scene, int interface) : full_(scene, interface), lean_(scene, interface) {}
    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override {
        return full_.initial_penetrations(position);
    }
    std::vector<EffectMemory> memory_by_effect() const override { return full_.memory_by_effect(); }
    DecisionStageCounts decision_stage_counts() const override { return full_.decision_stage_counts(); }
    ContactStep step(const Motion& motion) override {
        ContactStep full = full_.step(motion);
        const optimized::LeanStep& lean = lean_.step_lean(motion);
        EXPECT_EQ(full.active, lean.active);
        EXPECT_EQ(full.nodes.size(), lean.force.size());
        for (size_t i = 0; i < lean.force.size(); ++i) {
            EXPECT_EQ(full.nodes[i].force, lean.force[i]);
            EXPECT_EQ(full.nodes[i].step_stiffness, lean.step_stiffness[i]);
        }
        EXPECT_EQ(full.tool.force, lean.tool.force);
        EXPECT_EQ(full.sums.friction_work, lean.sums.friction_work);
        return full;
    }

  private:
    optimized::Contact full_, lean_;
};

TEST(LeanStep, HasTheForcesOfTheWholeStep) {
    march(
        scene_of("rotating_tool"), [](const Scene& s, int i) { return std::make_unique<FullAndLean>(s, i); },
        [](const CycleRecord&) {});
}

TEST(LeanStep, IsRefusedWhereItWouldLoseSomething) {
    const HostScene scene = scene_of("therm_form1_heat");
    optimized::Contact contact(scene, 0);
    EXPECT_THROW(contact.step_lean(Motion{}), std::logic_error);
}

}  // namespace
}  // namespace type21
