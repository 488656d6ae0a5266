#include "verification/results/compare/match_times.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace type21 {
namespace {

double largest_step(const std::vector<double>& times) {
    double largest = 0;
    for (size_t i = 1; i < times.size(); ++i)
        largest = std::max(largest, times[i] - times[i - 1]);
    return largest;
}

/// Smallest step; infinity with fewer than two times.
double smallest_step(const std::vector<double>& times) {
    double smallest = std::numeric_limits<double>::infinity();
    for (size_t i = 1; i < times.size(); ++i)
        smallest = std::min(smallest, times[i] - times[i - 1]);
    return smallest;
}

/// Index of the time nearest to t.
size_t nearest(const std::vector<double>& times, double t) {
    const auto after = std::lower_bound(times.begin(), times.end(), t);
    if (after == times.begin()) return 0;
    if (after == times.end()) return times.size() - 1;
    const auto index = static_cast<size_t>(after - times.begin());
    return t - times[index - 1] <= times[index] - t ? index - 1 : index;
}

struct Count {
    size_t count = 0;
    double first = 0;
    double last = 0;
    void add(double time) {
        if (count++ == 0) first = time;
        last = time;
    }
    std::string text(const char* what) const {
        if (count == 1) return fmt::format("1 {} (t = {:.9g})", what, first);
        return fmt::format("{} {}s (t = {:.9g} to {:.9g})", count, what, first, last);
    }
};

}  // namespace

double time_tolerance(const std::vector<double>& a, const std::vector<double>& b, double rounding) {
    const double step = std::min(smallest_step(a), smallest_step(b));
    if (!std::isfinite(step)) return 0;
    const double largest = std::max({std::abs(a.front()), std::abs(a.back()), std::abs(b.front()), std::abs(b.back())});
    return std::max(1e-6 * step, std::min(rounding * largest, 0.25 * step));
}

TimeMatch match_times(const TimesOf& thin_times, const TimesOf& full_times, const TimeWindow& window, double rounding) {
    const std::vector<double>& thin = thin_times.times;
    const std::vector<double>& full = full_times.times;
    const std::string &thin_name = thin_times.name, &full_name = full_times.name;
    TimeMatch match;
    const double tolerance = time_tolerance(thin, full, rounding);
    const auto in_window = [&](double t) { return t >= window.from - tolerance && t <= window.until + tolerance; };
    const auto inside_full = [&](double t) { return t > full.front() && t < full.back(); };
    const auto partner = [&](double t) {
        const size_t index = nearest(full, t);
        return std::abs(full[index] - t) <= tolerance ? index : full.size();
    };
    Count between, beyond, beyond_by_a_step, rest;
    for (const double t : thin)
        if (in_window(t) && partner(t) == full.size() && inside_full(t)) between.add(t);
    match.interpolated = between.count > 0;
    const double slack = match.interpolated ? std::max(largest_step(thin), largest_step(full)) : 0;

    for (size_t i = 0; i < thin.size(); ++i) {
        const double t = thin[i];
        if (!in_window(t)) continue;
        const size_t same = partner(t);
        if (same < full.size()) {
            match.pairs.push_back({i, same, 0});
        } else if (inside_full(t)) {
            const auto next = static_cast<size_t>(std::upper_bound(full.begin(), full.end(), t) - full.begin());
            match.pairs.push_back({i, next - 1, (t - full[next - 1]) / (full[next] - full[next - 1])});
        } else {
            const double distance = t < full.front() ? full.front() - t : t - full.back();
            (distance <= slack ? beyond_by_a_step : beyond).add(t);
        }
    }
    for (const double t : full)
        if (in_window(t) && (t < thin.front() - tolerance - slack || t > thin.back() + tolerance + slack)) rest.add(t);

    if (match.interpolated)
        match.notes.push_back(fmt::format("{} of {} without a partner: {} interpolated linearly", between.text("time"),
                                          thin_name, full_name));
    if (beyond_by_a_step.count > 0)
        match.notes.push_back(
            fmt::format("{} of {} outside the overlap left out", beyond_by_a_step.text("time"), thin_name));
    if (beyond.count > 0)
        (thin_times.may_go_on ? match.notes : match.mismatches)
            .push_back(fmt::format("{} of {} without a partner in {}, which covers t = {:.9g} to {:.9g}",
                                   beyond.text("time"), thin_name, full_name, full.front(), full.back()));
    if (rest.count > 0)
        (full_times.may_go_on ? match.notes : match.mismatches)
            .push_back(fmt::format("{} of {} without a partner in {}, which covers t = {:.9g} to {:.9g}",
                                   rest.text("time"), full_name, thin_name, thin.front(), thin.back()));
    if (match.pairs.empty() && match.mismatches.empty())
        match.mismatches.push_back(fmt::format("{} and {} have no time in common", thin_name, full_name));
    return match;
}

}  // namespace type21
