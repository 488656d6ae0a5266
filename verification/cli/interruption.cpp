#include "verification/cli/interruption.h"

#include <array>
#include <cstddef>

namespace type21::cli {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t came = 0;

/// Anything else than the first one kills.
void note(int signal) {
    came = signal;
    for (const int each : signals)
        std::signal(each, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
    came = 0;
    for (size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], nullptr, &before_[i]);
        if (before_[i].sa_handler == SIG_IGN) continue;
        struct sigaction action {};
        action.sa_handler = note;
        action.sa_flags = SA_RESTART;
        sigaction(signals[i], &action, nullptr);
    }
}

Interruption::~Interruption() {
    for (size_t i = 0; i < signals.size(); ++i)
        sigaction(signals[i], &before_[i], nullptr);
}

bool Interruption::asked() {
    return came != 0;
}

std::string_view Interruption::signal_name() {
    switch (came) {
        case SIGINT:
            return "SIGINT";
        case SIGTERM:
            return "SIGTERM";
        case SIGHUP:
            return "SIGHUP";
        default:
            return "";
    }
}

}  // namespace type21::cli
