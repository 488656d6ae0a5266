/// @file Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace type21 {

/// Calls work(0) .. work(count - 1), each once, in any order, at most `jobs` (at least one) at a time. After an
/// exception no further item is started; the first exception is thrown again when all threads are done.
void in_parallel(size_t count, int jobs, const std::function<void(size_t item)>& work);

}  // namespace type21
