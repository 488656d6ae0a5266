#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "verification/support/in_parallel.h"

namespace type21 {
namespace {

TEST(InParallel, EachItemIsDoneOnce) {
    for (const int jobs : {-1, 1, 2, 7}) {
        std::vector<std::atomic<int>> done(5);
        in_parallel(done.size(), jobs, [&](size_t i) { ++done[i]; });
        for (const auto& one : done)
            EXPECT_EQ(one, 1) << jobs;
    }
    in_parallel(0, 2, [](size_t) { FAIL() << "there is nothing to do"; });
}

TEST(InParallel, AnExceptionReachesTheCaller) {
    EXPECT_THROW(in_parallel(100, 3,
                             [](size_t i) {
                                 if (i == 41) throw std::runtime_error("41");
                             }),
                 std::runtime_error);
}

}  // namespace
}  // namespace type21
