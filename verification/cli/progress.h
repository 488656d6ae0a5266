/// @file The progress of a run on stderr.
#pragma once

#include <chrono>

#include "verification/results/record/run_deck.h"

namespace type21::cli {

/// On a terminal one line, refreshed five times a second; elsewhere at most ten lines, one for each tenth of the run.
class Progress {
  public:
    explicit Progress(std::string time_unit);

    void operator()(const RunProgress& progress);
    /// Ends the line, so that the next output starts on a new one.
    void finish();

  private:
    static void print(const std::string& text);

    std::string time_unit_;
    bool terminal_;
    bool line_open_ = false;
    int tenths_ = 0;
    std::chrono::steady_clock::time_point next_;
};

}  // namespace type21::cli
