#include "verification/performance/bench/targets.h"

#include <fmt/format.h>

namespace type21::bench {

std::string Target::reached() const {
    const auto holds = [&](double limit) { return better == Better::higher ? measured >= limit : measured <= limit; };
    if (holds(aim)) return "aim";
    return holds(at_least) ? "at least" : "no";
}

std::string to_text(const std::vector<Target>& targets) {
    if (targets.empty()) return {};
    std::string out =
        fmt::format("\n{:<62} {:>10} {:>9} {:>10}  {}\n", "target", "at least", "aim", "measured", "reached");
    const auto number = [](double value, const std::string& unit) { return fmt::format("{:.4g} {}", value, unit); };
    for (const Target& t : targets)
        out += fmt::format("{:<62} {:>10} {:>9} {:>10}  {}{}\n", t.target, number(t.at_least, t.unit),
                           number(t.aim, t.unit), number(t.measured, t.unit), t.reached(),
                           t.note.empty() ? "" : " (" + t.note + ")");
    return out;
}

}  // namespace type21::bench
