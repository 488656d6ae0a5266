// The same bits for registers of any width, on scenes whose nodes do not fill the last ones.
#include <cstring>

#include <gtest/gtest.h>

#include "optimized/contact.h"
#include "optimized/simd/simd_width.h"
#include "verification/performance/bench/bench_scene.h"

namespace type21::bench {
namespace {

void add(std::vector<double>& numbers, const Vec3& v) {
    numbers.insert(numbers.end(), v.data(), v.data() + 3);
}

std::vector<double> run(const BenchScene& scene, optimized::SimdWidth machine) {
    const optimized::SimdWidthCap narrow(machine);
    optimized::Contact whole(scene.scene, scene.interface), lean(scene.scene, scene.interface);
    std::vector<double> numbers;
    for (int cycle = 0; cycle < 12; ++cycle) {
        const Motion motion = scene.motion(cycle);
        const ContactStep step = whole.step(motion);
        for (const NodeContact& node : step.nodes) {
            add(numbers, node.force);
            add(numbers, node.point);
            numbers.insert(numbers.end(), {node.step_stiffness, node.distance, double(node.decision.segment)});
        }
        const optimized::LeanStep& same = lean.step_lean(motion);
        for (const ContactSums& sums : {step.sums, same.sums}) {
            for (const Vec3& v : {sums.normal, sums.tangential, sums.abs_normal, sums.abs_total})
                add(numbers, v);
            numbers.insert(numbers.end(), {sums.signed_normal, sums.norm_total, sums.elastic_energy, sums.friction_work,
                                           sums.damping_work});
        }
        for (const ToolLoad& load : {step.tool, same.tool}) {
            add(numbers, load.force);
            add(numbers, load.moment);
            numbers.insert(numbers.end(), {load.step_stiffness, load.step_rotation});
        }
    }
    return numbers;
}

TEST(Registers, OfAnyWidthGiveTheSameBits) {
    // 121, 196 and 49 nodes: the last part of a batch ends within a register.
    for (const BenchScene& scene :
         {bowl_bench(10, 28), bowl_bench(13, 20), ties_bench(6), pan_bench("pan", 900, 300, 1)}) {
        const std::vector<double> eight = run(scene, optimized::SimdWidth::eight);
        for (const optimized::SimdWidth machine : {optimized::SimdWidth::four, optimized::SimdWidth::two}) {
            const std::vector<double> numbers = run(scene, machine);
            ASSERT_EQ(numbers.size(), eight.size());
            EXPECT_EQ(std::memcmp(numbers.data(), eight.data(), eight.size() * sizeof(double)), 0)
                << scene.name << " " << static_cast<int>(machine);
        }
    }
}

}  // namespace
}  // namespace type21::bench
