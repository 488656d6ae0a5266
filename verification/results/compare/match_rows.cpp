#include "verification/results/compare/match_rows.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "verification/results/compare/match_times.h"

namespace type21 {
namespace {

/// Rows of one time by object.
using Snapshot = std::map<Id, size_t>;

struct History {
    std::vector<double> times;
    std::vector<Snapshot> snapshots;
};

History by_time(const CsvTable& table, const char* name, std::vector<std::string>& mismatches) {
    std::map<double, Snapshot> sorted;
    size_t twice = 0;
    for (size_t row = 0; row < table.rows(); ++row) {
        const Id object = table.has_object ? table.object[row] : 0;
        if (!sorted[table.time[row]].emplace(object, row).second) ++twice;
    }
    if (twice > 0) mismatches.push_back(fmt::format("{} rows of {} are there twice", twice, name));
    History history;
    for (auto& [time, snapshot] : sorted) {
        history.times.push_back(time);
        history.snapshots.push_back(std::move(snapshot));
    }
    return history;
}

/// The row of an object at one time, or between that time and the next; false when it is not there.
bool find_side(const History& history, size_t time, double weight, Id object, RowPair::Side& side) {
    const auto here = history.snapshots[time].find(object);
    if (here == history.snapshots[time].end()) return false;
    side = {here->second, here->second, weight};
    if (weight == 0) return true;
    const auto next = history.snapshots[time + 1].find(object);
    if (next == history.snapshots[time + 1].end()) return false;
    side.next = next->second;
    return true;
}

Coverage covered(const std::vector<double>& ours, const std::vector<double>& reference, const TimeWindow& window) {
    const double begin = std::max(ours.front(), window.from), end = std::min(ours.back(), window.until);
    Coverage out{std::max(begin, reference.front()), std::min(end, reference.back()), 1};
    if (end > begin) out.share = std::max(0.0, (out.until - out.from) / (end - begin));
    return out;
}

/// The first ten by name.
void complain_about_missing(const std::map<Id, size_t>& missing, size_t times, std::vector<std::string>& mismatches) {
    constexpr size_t most = 10;
    size_t said = 0;
    for (const auto& [object, count] : missing) {
        if (said++ == most) {
            mismatches.push_back(fmt::format("{} more objects have no partner", missing.size() - most));
            return;
        }
        mismatches.push_back(fmt::format("object {} has no partner at {} of {} times", object, count, times));
    }
}

}  // namespace

RowMatch match_rows(const CsvTable& ours, const CsvTable& reference, const TimeWindow& window, bool shorter_reference) {
    RowMatch match;
    if (ours.has_object != reference.has_object) {
        match.mismatches.emplace_back("only one of the two files has a node column");
        return match;
    }
    const History a = by_time(ours, "ours", match.mismatches);
    const History b = by_time(reference, "the reference", match.mismatches);
    if (a.times.empty()) match.mismatches.emplace_back("ours has no rows");
    if (b.times.empty()) match.mismatches.emplace_back("the reference has no rows");
    if (a.times.empty() || b.times.empty()) return match;

    const bool ours_thin = a.times.size() < b.times.size();
    const double rounding = std::max(ours.rounding, reference.rounding);
    const auto free_to_go_on = [&](bool is_ours) { return shorter_reference && is_ours; };
    TimeMatch times = ours_thin ? match_times({a.times, "ours", free_to_go_on(true)},
                                              {b.times, "the reference", free_to_go_on(false)}, window, rounding)
                                : match_times({b.times, "the reference", free_to_go_on(false)},
                                              {a.times, "ours", free_to_go_on(true)}, window, rounding);
    match.coverage = covered(a.times, b.times, window);
    if (shorter_reference && match.coverage.share == 0 && a.times.size() > 1)
        match.mismatches.emplace_back("the reference covers no time of ours");
    match.interpolated = times.interpolated;
    match.notes = std::move(times.notes);
    match.mismatches.insert(match.mismatches.end(), times.mismatches.begin(), times.mismatches.end());

    std::map<Id, size_t> missing;
    for (const TimePair& pair : times.pairs) {
        const size_t in_a = ours_thin ? pair.thin : pair.full;
        const size_t in_b = ours_thin ? pair.full : pair.thin;
        for (const auto& [object, row] : b.snapshots[in_b]) {
            RowPair rows;
            rows.time = b.times[in_b];
            rows.object = object;
            const bool there = find_side(a, in_a, ours_thin ? 0 : pair.weight, object, rows.ours) &&
                               find_side(b, in_b, ours_thin ? pair.weight : 0, object, rows.reference);
            if (ours_thin) rows.time = a.times[in_a];
            if (there) {
                match.pairs.push_back(rows);
            } else {
                ++missing[object];
            }
        }
    }
    complain_about_missing(missing, times.pairs.size(), match.mismatches);
    return match;
}

}  // namespace type21
