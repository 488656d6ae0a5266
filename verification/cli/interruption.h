/// @file Signals that end a run: from the terminal, from a batch system.
#pragma once

#include <csignal>
#include <string_view>

namespace type21::cli {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP is only noted, so that the run can end between two cycles; the
/// second one ends the program. A signal that is ignored, as SIGHUP under nohup, stays ignored.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    static bool asked();
    /// "SIGTERM"; empty while none has come.
    static std::string_view signal_name();

  private:
    struct sigaction before_[3];
};

}  // namespace type21::cli
