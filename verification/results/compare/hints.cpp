#include "verification/results/compare/hints.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace type21 {
namespace {

struct Fit {
    double factor = 0;
    double residual = 1;  ///< largest |a - factor b| / largest |a|
};

/// a = factor b, with the least squares of the differences.
Fit fit(const std::vector<double>& a, const std::vector<double>& b) {
    double ab = 0, bb = 0, largest = 0, largest_b = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i]));
        largest_b = std::max(largest_b, std::abs(b[i]));
    }
    Fit out;
    if (!(largest > 0) || !(largest_b > 0) || !std::isfinite(largest) || !std::isfinite(largest_b)) return out;
    for (size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] / largest) * (b[i] / largest_b);
        bb += (b[i] / largest_b) * (b[i] / largest_b);
    }
    const double scaled = ab / bb;
    out.residual = 0;
    for (size_t i = 0; i < a.size(); ++i)
        out.residual = std::max(out.residual, std::abs(a[i] / largest - scaled * (b[i] / largest_b)));
    out.factor = scaled * (largest / largest_b);
    return out;
}

/// n of 10^3n, where a factor is that within a hundredth; 0 else.
int thousands(double factor) {
    const double exponent = std::log10(std::abs(factor)) / 3;
    const double whole = std::round(exponent);
    return std::abs(3 * (exponent - whole)) < std::log10(1.01) ? static_cast<int>(whole) : 0;
}

bool is_one(double factor) {
    return std::abs(std::abs(factor) - 1) < 0.01;
}

std::string power_of_ten(int n) {
    return n > 0 && n <= 2 ? (n == 1 ? "1000" : "1e6") : fmt::format("1e{}", 3 * n);
}

std::vector<double> integral(const std::vector<double>& time, const std::vector<double>& values) {
    std::vector<double> out(values.size(), 0.0);
    for (size_t i = 1; i < values.size(); ++i)
        out[i] = out[i - 1] + 0.5 * (values[i] + values[i - 1]) * (time[i] - time[i - 1]);
    return out;
}

std::string hint_on_factor(const Fit& found) {
    if (std::isfinite(found.factor) && is_one(found.factor))
        return found.factor < 0
                   ? "ours is the opposite of the reference: action and reaction, such as the force on the "
                     "blank where ours is on the tool; --scale COLUMN=-1 turns the reference"
                   : "";
    const int n = thousands(found.factor);
    const char* sign = found.factor < 0 ? "-" : "";
    if (n != 0)
        return fmt::format(
            "ours is {}{} times the reference at all times: other units{}; --scale COLUMN={}{} converts "
            "the reference",
            sign, power_of_ten(n), found.factor < 0 ? " and the opposite sign" : "", sign, power_of_ten(n));
    return fmt::format("ours is {:.6g} times the reference at all times", found.factor);
}

}  // namespace

std::string hint_on_values(const PairedColumn& column) {
    constexpr double same = 1e-3, same_integral = 0.05;
    if (column.ours.size() < 2) return "";
    const Fit values = fit(column.ours, column.reference);
    // Two rows, of which one is 0, fit any factor.
    const auto not_zero = std::count_if(column.ours.begin(), column.ours.end(), [](double v) { return v != 0; });
    if (values.residual < same && not_zero >= 2) return hint_on_factor(values);
    if (column.ours.size() < 5 || not_zero < 3) return "";
    std::vector<double> from_begin = column.ours;
    for (double& value : from_begin)
        value -= column.ours.front();
    const Fit rate = fit(from_begin, integral(column.time, column.reference));
    const int n = thousands(rate.factor);
    // The integral knows its size to the same precision.
    const double size = std::abs(rate.factor) / std::pow(10.0, 3 * std::round(std::log10(std::abs(rate.factor)) / 3));
    if (rate.residual > same_integral || std::abs(size - 1) > same_integral) return "";
    const std::string factor = n == 0 && rate.factor > 0 ? ""
                                                         : fmt::format(" times {}{}", rate.factor < 0 ? "-" : "",
                                                                       n == 0 ? "1" : power_of_ten(n));
    return fmt::format(
        "the reference looks like the rate of ours, such as a force where ours is an impulse: its "
        "integral over time{} is ours within {:.2g} %; compare with the integral",
        factor, 100 * rate.residual);
}

void HintList::add(const std::string& column, const std::string& hint) {
    if (hint.empty()) return;
    for (auto& [known, columns] : hints_) {
        if (known != hint) continue;
        if (std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
        return;
    }
    hints_.push_back({hint, {column}});
}

std::vector<std::string> HintList::lines() const {
    std::vector<std::string> out;
    for (const auto& [hint, columns] : hints_)
        out.push_back(fmt::format("{}: {}", fmt::join(columns, ", "), hint));
    return out;
}

std::string hint_on_ids(const std::set<Id>& ours, const std::set<Id>& reference) {
    if (ours.empty() || reference.empty()) return "";
    for (const Id id : reference)
        if (ours.contains(id)) return "";
    std::string out =
        fmt::format("no id in common: the reference has {} ids, {} to {}, ours {}, {} to {}", reference.size(),
                    *reference.begin(), *reference.rbegin(), ours.size(), *ours.begin(), *ours.rbegin());
    const Id distance = *ours.begin() - *reference.begin();
    const bool constant = ours.size() == reference.size() && std::equal(ours.begin(), ours.end(), reference.begin(),
                                                                        [&](Id a, Id b) { return a - b == distance; });
    if (constant) out += fmt::format("; each of ours is {} {}", std::abs(distance), distance > 0 ? "more" : "less");
    return out;
}

std::string hint_on_interface(const std::string& file, const std::set<Id>& ours) {
    if (!file.starts_with("interface_") || ours.empty()) return "";
    return fmt::format("no id in common: the run has the {} {}; --map interface_<id>:FNX=... names one",
                       ours.size() == 1 ? "interface" : "interfaces", fmt::join(ours, ", "));
}

std::string hint_on_times(const std::vector<double>& ours, const std::vector<double>& reference) {
    if (ours.empty() || reference.empty()) return "";
    const double a = ours.back(), b = reference.back();
    if (!(a > 0) || !(b > 0)) return "";
    const double n = std::round(std::log10(a / b) / 3);
    if (n == 0 || std::abs(a / b / std::pow(10.0, 3 * n) - 1) > 0.1) return "";
    return fmt::format(
        "ours ends at t = {:.9g}, the reference at {:.9g}: other units of time; --time-scale {} converts "
        "the reference",
        a, b, power_of_ten(static_cast<int>(n)));
}

}  // namespace type21
