#include <cstdio>

#include <fmt/format.h>

#include "verification/cli/verbs.h"

namespace type21::cli {

void print_problems(const Problems& problems) {
    if (problems.list().empty()) return;
    for (const Problem& problem : problems.list())
        fmt::print(stderr, "{}\n", to_text(problem));
    const auto count = [](int n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); };
    fmt::print(stderr, "{}, {}\n", count(problems.error_count(), "error"), count(problems.warning_count(), "warning"));
}

}  // namespace type21::cli
