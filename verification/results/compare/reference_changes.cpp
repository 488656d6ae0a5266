#include "verification/results/compare/reference_changes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "verification/results/compare/column_units.h"
#include "verification/support/shown_text.h"

namespace type21 {
namespace {

std::string full_name(const std::string& column, const std::string& unit) {
    return unit.empty() ? column : fmt::format("{} [{}]", column, unit);
}

}  // namespace

std::string listed(const std::vector<std::string>& names) {
    constexpr size_t most = 40;
    if (names.empty()) return "none";
    if (names.size() <= most) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} and {} more", fmt::join(names.begin(), names.begin() + most, ", "), names.size() - most);
}

std::string ReferenceChanger::time_name() const {
    for (const auto& [ours, theirs] : changes_.map)
        if (ours == "time") return name_and_unit(theirs).name;
    return "time";
}

std::string ReferenceChanger::mapped(const std::string& column, const std::string& unit) {
    seen_.insert(full_name(column, unit));
    for (const auto& [ours, theirs] : changes_.map) {
        if (theirs != column && theirs != full_name(column, unit)) {
            const NameAndUnit named = name_and_unit(theirs);
            if (named.name != column || named.unit != unit) continue;
        }
        used_.insert("--map " + theirs);
        return ours;
    }
    return "";
}

void ReferenceChanger::rename(CsvTable& table) {
    for (size_t c = 0; c < table.columns.size(); ++c)
        if (const std::string ours = mapped(table.columns[c], table.unit(c)); !ours.empty()) table.columns[c] = ours;
}

void ReferenceChanger::require_targets(const std::vector<std::string>& columns, const std::string& file) const {
    for (const auto& [ours, theirs] : changes_.map) {
        if (!used_.contains("--map " + theirs) || ours.find(':') != std::string::npos) continue;
        if (std::find(columns.begin(), columns.end(), ours) == columns.end())
            throw WrongOption(fmt::format("--map {}={}: {} of the run has no column '{}'; it has {}", ours, theirs,
                                          file, ours, listed(columns)));
    }
}

void ReferenceChanger::convert_times(CsvTable& table, std::vector<std::string>& notes) {
    double factor = changes_.time_scale.value_or(1);
    if (!changes_.time_scale && !table.time_unit.empty()) {
        const std::optional<Unit> unit = unit_of(table.time_unit);
        const std::string shown_unit = shown(table.time_unit);
        if (!unit || unit->dimension != dim::time) {
            notes.push_back(
                fmt::format("the unit [{}] of the times is not understood: they are taken as they are", shown_unit));
        } else if (!run_.units()) {
            notes.push_back(
                fmt::format("the times are in {}; the run names no units (run.json): taken as they are", shown_unit));
        } else {
            factor = unit->si / run_.units()->time;
            notes.push_back(factor == 1 ? fmt::format("the times are in {}, as ours", shown_unit)
                                        : fmt::format("the times are in {}, ours in {}: multiplied by {:.9g}",
                                                      shown_unit, run_.units()->time_name, factor));
        }
    }
    if (factor == 1) return;
    for (double& time : table.time)
        time *= factor;
}

double ReferenceChanger::factor_of(const CsvTable& table, size_t column, const std::string& name,
                                   std::vector<std::string>& notes) {
    for (const auto& [scaled, factor] : changes_.scale) {
        if (scaled != name && scaled != table.columns[column]) continue;
        used_.insert("--scale " + scaled);
        return factor;
    }
    const std::string text = table.unit(column);
    if (text.empty()) return 1;
    const std::optional<Unit> unit = unit_of(text);
    const std::optional<Dimension> dimension = dimension_of(name);
    if (!unit || !dimension || !run_.units()) {
        notes.push_back(fmt::format("{}: the unit [{}] is not understood: taken as it is", name, text));
        return 1;
    }
    const std::string ours = run_.units()->name(*dimension);
    if (unit->dimension != *dimension) {
        const bool is_rate = unit->dimension ==
                             Dimension{dimension->mass, dimension->length, dimension->time - 1, dimension->temperature};
        notes.push_back(fmt::format(
            "{}: the reference is in {}, ours in {}: {}", name, text, ours,
            is_rate ? "it is the rate of ours in time, such as a force where ours is an impulse" : "another quantity"));
        return 1;
    }
    const double factor = unit->si / run_.units()->si(*dimension);
    if (std::abs(factor - 1) < 1e-12) return 1;
    notes.push_back(
        fmt::format("{}: the reference is in {}, ours in {}: multiplied by {:.9g}", name, text, ours, factor));
    return factor;
}

void ReferenceChanger::convert(CsvTable& table, const std::vector<std::string>& names,
                               std::vector<std::string>& notes) {
    convert_times(table, notes);
    std::vector<std::string> of_columns;
    for (size_t c = 0; c < table.columns.size(); ++c) {
        seen_.insert(full_name(table.columns[c], table.unit(c)));
        if (names[c].empty()) continue;
        seen_.insert(names[c]);
        const double factor = factor_of(table, c, names[c], of_columns);
        if (factor == 1) continue;
        for (double& value : table.values[c])
            value *= factor;
    }
    for (std::string& note : of_columns)
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(std::move(note));
}

void ReferenceChanger::finish() const {
    const std::string there = listed({seen_.begin(), seen_.end()});
    for (const auto& [ours, theirs] : changes_.map)
        if (ours != "time" && !used_.contains("--map " + theirs))
            throw WrongOption(
                fmt::format("--map {}={}: the reference has no column '{}'; it has {}", ours, theirs, theirs, there));
    for (const auto& [column, factor] : changes_.scale)
        if (!used_.contains("--scale " + column))
            throw WrongOption(
                fmt::format("--scale {}={:g}: there is no column '{}'; there are {}", column, factor, column, there));
}

}  // namespace type21
