#include "verification/cli/progress.h"

#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

namespace type21::cli {

Progress::Progress(std::string time_unit)
    : time_unit_(std::move(time_unit)),
      terminal_(isatty(STDERR_FILENO) == 1),
      next_(std::chrono::steady_clock::now()) {}

void Progress::operator()(const RunProgress& progress) {
    const int tenths = static_cast<int>(progress.fraction * 10);
    const auto now = std::chrono::steady_clock::now();
    if (terminal_ ? (now < next_ && !progress.last) : tenths <= tenths_) return;
    tenths_ = tenths;
    next_ = now + std::chrono::milliseconds(200);
    line_open_ = terminal_;
    print(fmt::format("{}{:5.1f} %  cycle {:>8}  time {:.6e} {}  {:.0f} s left{}", terminal_ ? "\r" : "",
                      100 * progress.fraction, progress.cycle, progress.time, time_unit_, progress.time_left,
                      terminal_ ? "   " : "\n"));
}

void Progress::print(const std::string& text) {
    // The run is worth more than its progress: where nobody reads it any more, the run goes on.
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

void Progress::finish() {
    if (line_open_) print("\n");
    line_open_ = false;
}

}  // namespace type21::cli
