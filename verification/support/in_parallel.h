/// @file Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace type21 {

/// Calls work(0) .. work(count - 1), at most `jobs` at a time (at least one), each once and in no order. An exception
/// ends the handing out; the first one is thrown on when all threads have come back.
void in_parallel(size_t count, int jobs, const std::function<void(size_t item)>& work);

}  // namespace type21
