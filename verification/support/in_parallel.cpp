#include "verification/support/in_parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace type21 {

void in_parallel(size_t count, int jobs, const std::function<void(size_t item)>& work) {
    std::atomic<size_t> next{0};
    std::mutex failing;
    std::exception_ptr failure;
    const auto loop = [&] {
        try {
            for (size_t i = next++; i < count; i = next++)
                work(i);
        } catch (...) {
            const std::lock_guard<std::mutex> lock(failing);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::thread> pool;
    for (size_t i = 1; i < std::min(static_cast<size_t>(std::max(jobs, 1)), count); ++i)
        pool.emplace_back(loop);
    loop();
    for (std::thread& thread : pool)
        thread.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace type21
