/// @file Functions of time that end before the run: what follows is their last slope.
#include <string>

#include <fmt/format.h>

#include "reference/host/warnings/warnings.h"
#include "reference/model/motion_keyword.h"

namespace type21 {
namespace {

/// The end of a run and of a function may differ by what decimal numbers lose.
constexpr double rounding = 1e-6;

/// One use of a function of time.
struct Use {
    std::string_view keyword;
    Id id = 0;
    int function = -1;
    double scale_x = 1;  ///< [time]
    double delay = 0;    ///< time at which the abscissa is 0 [time]
    double stop = 0;     ///< no use afterwards [time]
    bool holds = false;  ///< a value that stays is nothing new: a displacement, a temperature
};

/// Behind its last point a function goes on as it was between the last two.
double last_slope(const Function& function) {
    const size_t n = function.x.size();
    return n < 2 ? 0 : (function.y[n - 1] - function.y[n - 2]) / (function.x[n - 1] - function.x[n - 2]);
}

bool is_constant(const Function& function) {
    for (const double y : function.y)
        if (y != function.y.front()) return false;
    return true;
}

void judge(const SurpriseCheck& check, const Use& use) {
    if (use.function < 0) return;
    const Function& function = check.model.functions[static_cast<size_t>(use.function)];
    if (function.x.empty() || is_constant(function)) return;
    const double end = use.delay + function.x.back() * use.scale_x;
    const double last = std::min(use.stop, check.model.engine.end_time);
    if (!(end < last - rounding * last)) return;
    const double slope = last_slope(function);
    if (slope == 0 && (use.holds || function.y.back() == 0)) return;
    const double then = function((last - use.delay) / use.scale_x);
    check.at_card(
        use.keyword, use.id, "fct_IDT",
        fmt::format("{} with its last point at {}", function.id, check.quantity(end, dim::time)),
        fmt::format("the function ends before the run does, {}: it goes on along its last two points, from {:.6g} "
                    "to {:.6g}",
                    check.quantity(last, dim::time), function.y.back(), then),
        "Give the function points up to the end of the run, or end the drive with it (Tstop)");
}

/// Only a sensor that nothing but time switches has a delay that is known beforehand.
bool starts_with_the_run(int sensor) {
    return sensor < 0;
}

}  // namespace

void warn_of_ending_functions(const SurpriseCheck& check) {
    const Model& model = check.model;
    constexpr double always = 1e30;
    for (const ImposedMotion& motion : model.imposed_motions) {
        const bool holds = motion.kind == ImposedMotion::Kind::displacement;
        if (starts_with_the_run(motion.sensor))
            judge(check, {keyword_of(motion.kind), motion.id, motion.function, motion.scale_x, 0, motion.stop, holds});
    }
    for (const ConcentratedLoad& load : model.loads)
        if (starts_with_the_run(load.sensor))
            judge(check, {"CLOAD", load.id, load.function, load.scale_x, 0, always, true});
    for (const Gravity& gravity : model.gravities)
        if (starts_with_the_run(gravity.sensor))
            judge(check, {"GRAV", gravity.id, gravity.function, gravity.scale_x, 0, always, true});
    for (const ImposedTemperature& heat : model.imposed_temperatures)
        if (starts_with_the_run(heat.sensor))
            judge(check, {"IMPTEMP", heat.id, heat.function, heat.scale_x, 0, heat.stop, true});
}

}  // namespace type21
