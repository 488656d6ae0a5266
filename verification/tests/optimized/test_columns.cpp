// Vectors of nodes in rows and back, and what balls hold, for every machine and every number of nodes.
#include <random>

#include <gtest/gtest.h>

#include "optimized/kernel/columns.h"
#include "optimized/search/memory.h"

namespace type21::optimized {
namespace {

constexpr int capacity = 40;
constexpr double untouched = -7;

std::vector<Vec3> numbered(int count) {
    std::vector<Vec3> vectors;
    for (int i = 0; i < count; ++i)
        vectors.push_back(Vec3(10 * i, 10 * i + 1, 10 * i + 2));
    return vectors;
}

class Columns : public ::testing::TestWithParam<SimdWidth> {
  protected:
    void SetUp() override {
        if (GetParam() > this_machine()) GTEST_SKIP() << "this processor has no such registers";
    }
    std::array<std::vector<double>, 3> rows_{std::vector<double>(capacity, untouched),
                                             std::vector<double>(capacity, untouched),
                                             std::vector<double>(capacity, untouched)};
    Components components() { return {rows_[0].data(), rows_[1].data(), rows_[2].data()}; }
};

TEST_P(Columns, TurnWhatStandsInOrder) {
    for (int count = 0; count <= capacity; ++count) {
        std::vector<V3> from;
        for (const Vec3& v : numbered(count))
            from.push_back({v[0], v[1], v[2]});
        from.push_back({});  // a pointer to none is one too
        for (auto& row : rows_)
            std::fill(row.begin(), row.end(), untouched);
        into_rows(from.data(), count, components(), GetParam());
        for (int a = 0; a < 3; ++a)
            for (int j = 0; j < capacity; ++j)
                ASSERT_EQ(rows_[static_cast<size_t>(a)][static_cast<size_t>(j)], j < count ? 10 * j + a : untouched);
        std::vector<V3> back(capacity + 1, V3{untouched, untouched, untouched});
        from_rows(ConstComponents{rows_[0].data(), rows_[1].data(), rows_[2].data()}, count, back.data(), GetParam());
        for (int j = 0; j < capacity; ++j)
            for (int a = 0; a < 3; ++a)
                ASSERT_EQ(back[static_cast<size_t>(j)][a], j < count ? 10 * j + a : untouched) << count;
    }
}

TEST_P(Columns, TurnWhatIsChosen) {
    std::mt19937 random(5);
    const std::vector<Vec3> from = numbered(200);
    for (int round = 0; round < 400; ++round) {
        const int count = static_cast<int>(random() % (capacity + 1));
        // Runs of neighbours, with jumps ahead and back, and the same one twice.
        std::vector<int> index;
        int next = static_cast<int>(random() % 100);
        for (int j = 0; j < count; ++j) {
            index.push_back(next);
            next = random() % 12 != 0 ? std::min(next + 1, 199) : static_cast<int>(random() % 200);
            if (random() % 30 == 0) next = index.back();
        }
        index.push_back(0);
        into_rows(from, index.data(), count, components(), GetParam());
        for (int a = 0; a < 3; ++a)
            for (int j = 0; j < count; ++j)
                ASSERT_EQ(rows_[static_cast<size_t>(a)][static_cast<size_t>(j)],
                          from[static_cast<size_t>(index[static_cast<size_t>(j)])][a]);
    }
}

TEST_P(Columns, RecallTheSameOnAllMachines) {
    std::mt19937 random(6);
    std::normal_distribution<double> number;
    std::array<int, 5> met{};
    for (int count = 0; count <= capacity; ++count) {
        std::vector<Memory> memory(capacity);
        for (int j = 0; j < capacity; ++j) {
            Memory& one = memory[static_cast<size_t>(j)];
            one.last = SubTriangleId::from_code(static_cast<int>(random() % 5) - 1);
            one.center = {number(random), number(random), number(random)};
            one.radius = random() % 5 == 0 ? 0.0F : static_cast<float>(number(random));
            one.contact_safe = random() % 3 == 0 ? 0.0F : 0.7F * static_cast<float>(number(random));
            for (int a = 0; a < 3; ++a)
                rows_[static_cast<size_t>(a)][static_cast<size_t>(j)] = one.center[a] + 0.5 * number(random);
        }
        const float small = count % 4 == 0 ? HUGE_VALF : 0.1F * static_cast<float>(count % 4);
        Recalled found;
        std::fill_n(found.what, Recalled::capacity, 5);
        found.find(memory.data(), {rows_[0].data(), rows_[1].data(), rows_[2].data()}, count, small, GetParam());
        for (int j = 0; j < count; ++j) {
            const auto i = static_cast<size_t>(j);
            const int what = Recalled::of(memory[i], {rows_[0][i], rows_[1][i], rows_[2][i]}, small);
            ASSERT_EQ(found.what[j], what) << count << " " << j;
            ASSERT_EQ(found.last[j], memory[i].last);
            ++met[static_cast<size_t>(what)];
        }
        for (int j = count; j < capacity; ++j)
            ASSERT_EQ(found.what[j], 5);
    }
    for (const int times : met)
        EXPECT_GT(times, 20);
}

INSTANTIATE_TEST_SUITE_P(Machines, Columns, ::testing::Values(SimdWidth::two, SimdWidth::four, SimdWidth::eight),
                         [](const auto& machine) { return "lanes" + std::to_string(static_cast<int>(machine.param)); });

}  // namespace
}  // namespace type21::optimized
