#include "verification/performance/bench/timing.h"

#include <algorithm>
#include <stdexcept>

namespace type21::bench {

void Rounds::add(std::string name, std::function<double()> run, int times) {
    methods_.push_back({std::move(name), std::move(run), times, {}});
}

int Rounds::run(int repeats, double seconds) {
    const Watch watch(false);
    for (int r = 0; r <= repeats; ++r) {
        if (r > 3 && watch.seconds() > seconds) return r - 1;
        for (Method& method : methods_) {
            if (method.times < 0 && (r == 0 || (r - 1) % -method.times != 0)) continue;
            for (int i = 0; i < std::max(method.times, 1); ++i) {
                const double time = method.run();
                if (r > 0) method.times_taken.push_back(time);
            }
        }
    }
    return repeats;
}

const std::vector<double>& Rounds::times_of(const std::string& name) const {
    for (const Method& method : methods_)
        if (method.name == name) return method.times_taken;
    throw std::invalid_argument("bench: nothing called '" + name + "' was timed");
}

bool Rounds::has(const std::string& name) const {
    return std::any_of(methods_.begin(), methods_.end(), [&](const Method& method) { return method.name == name; });
}

TimingSpread Rounds::of(const std::string& name) const {
    return timing_spread(times_of(name));
}

double Rounds::of_medians(const std::string& slow, const std::string& fast) const {
    return of(slow).p50 / of(fast).p50;
}

double Rounds::of_minima(const std::string& slow, const std::string& fast) const {
    return of(slow).min / of(fast).min;
}

}  // namespace type21::bench
