#include "verification/results/compare/compare_tables.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "verification/results/compare/column_group.h"
#include "verification/results/compare/header_name.h"
#include "verification/results/compare/hints.h"
#include "verification/support/nearest_word.h"
#include "verification/support/shown_text.h"

namespace type21 {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

double value(const std::vector<double>& column, const RowPair::Side& side) {
    if (side.weight == 0) return column[side.row];
    return (1 - side.weight) * column[side.row] + side.weight * column[side.next];
}

/// |a - b|; a NaN compares as nothing at all and equal infinities differ by NaN: neither is agreement.
double distance(double a, double b) {
    return std::isfinite(a) && std::isfinite(b) ? std::abs(a - b) : std::numeric_limits<double>::infinity();
}

double scaled_by(double scale, double difference) {
    return difference == 0 ? 0 : difference / scale;
}

/// The rows are in the order of time, and of ids within one time.
ColumnResult compare_column(const std::vector<double>& ours, const std::vector<double>& reference,
                            const RowMatch& match, bool has_object, double scale, double tolerance) {
    ColumnResult result;
    result.scale = scale;
    result.tolerance = tolerance;
    size_t bad = 0;
    bool first = true;
    for (const RowPair& pair : match.pairs) {
        const double a = value(ours, pair.ours);
        const double b = value(reference, pair.reference);
        const double difference = distance(a, b);
        bad += std::isinf(difference) ? 1 : 0;
        if (!result.first && scaled_by(scale, difference) > tolerance)
            result.first = {pair.time, has_object ? std::optional(pair.object) : std::nullopt, a, b};
        if (!first && difference <= result.difference) continue;
        first = false;
        result.difference = difference;
        result.time = pair.time;
        if (has_object) result.object = pair.object;
        result.ours = a;
        result.reference = b;
    }
    result.scaled = scaled_by(scale, result.difference);
    result.ok = result.scaled <= tolerance;
    if (bad > 0) result.remark = fmt::format("not a finite number in {} of {} rows", bad, match.pairs.size());
    return result;
}

void complain_about_names(const CsvTable& ours, const CsvTable& reference, const CompareOptions& options,
                          TableResult& out) {
    for (const std::string& name : options.columns)
        if (!reference.column(name))
            out.mismatches.push_back(
                fmt::format("column {} is not in the reference{}", name, ours.column(name) ? "" : " nor in ours"));
    for (const std::string& name : options.exclude)
        if (!reference.column(name))
            out.mismatches.push_back(fmt::format("column {} is to be left out but is not in the reference", name));
    for (const Id object : options.objects)
        if (std::find(reference.object.begin(), reference.object.end(), object) == reference.object.end())
            out.mismatches.push_back(fmt::format("object {} is not in the reference", object));
}

std::string missing_column(const std::string& name, const CsvTable& ours) {
    const std::string out = fmt::format("column {} is missing", shown(name));
    // A name that a run may have was not asked for in the deck; what another name means, only its author knows.
    if (!known_column(name).empty()) return out;
    const std::string_view nearest = nearest_word(name, {ours.columns.begin(), ours.columns.end()});
    return fmt::format("{}; --map {}='{}' says which of ours it is", out, nearest.empty() ? "OURS" : nearest,
                       shown(name));
}

/// The rows of one object, or all.
PairedColumn paired(const std::string& name, const std::vector<double>& ours, const std::vector<double>& reference,
                    const RowMatch& match, std::optional<Id> object) {
    PairedColumn out{name, {}, {}, {}};
    for (const RowPair& pair : match.pairs) {
        if (object && pair.object != *object) continue;
        out.time.push_back(pair.time);
        out.ours.push_back(value(ours, pair.ours));
        out.reference.push_back(value(reference, pair.reference));
    }
    return out;
}

void add_row_hints(const CsvTable& ours, const CsvTable& reference, std::vector<std::string>& hints) {
    const std::string ids =
        hint_on_ids({ours.object.begin(), ours.object.end()}, {reference.object.begin(), reference.object.end()});
    const std::string times = hint_on_times(ours.time, reference.time);
    for (const std::string& hint : {ids, times})
        if (!hint.empty()) hints.push_back(hint);
}

}  // namespace

bool TableResult::ok() const {
    return mismatches.empty() && !columns.empty() &&
           std::all_of(columns.begin(), columns.end(), [](const ColumnResult& column) { return column.ok; });
}

const ColumnResult* TableResult::worst() const {
    const auto worst =
        std::max_element(columns.begin(), columns.end(),
                         [](const ColumnResult& a, const ColumnResult& b) { return a.scaled < b.scaled; });
    return worst == columns.end() ? nullptr : &*worst;
}

TableResult compare_tables(const CsvTable& ours, const CsvTable& reference, const CompareOptions& options) {
    TableResult out;
    out.ours = ours.file;
    out.reference = reference.file;
    complain_about_names(ours, reference, options, out);

    const CsvTable chosen = filtered(reference, {}, options.objects);
    RowMatch match = match_rows(ours, chosen, options.window, options.shorter_reference);
    out.rows = match.pairs.size();
    out.coverage = match.coverage;
    out.notes = std::move(match.notes);
    out.mismatches.insert(out.mismatches.end(), match.mismatches.begin(), match.mismatches.end());

    const std::vector<double> scales =
        column_scales(filtered(chosen, options.window, {}), filtered(ours, options.window, {}), options.tolerance);
    HintList values;
    for (size_t c = 0; c < chosen.columns.size(); ++c) {
        const std::string& name = chosen.columns[c];
        if (contains(options.exclude, name)) {
            out.notes.push_back(fmt::format("column {} left out", name));
            continue;
        }
        if (!options.columns.empty() && !contains(options.columns, name)) continue;
        const std::optional<size_t> mine = ours.column(name);
        if (!mine) {
            out.mismatches.push_back(missing_column(name, ours));
            continue;
        }
        if (match.pairs.empty()) continue;
        ColumnResult result = compare_column(ours.values[*mine], chosen.values[c], match, chosen.has_object, scales[c],
                                             options.tolerance);
        result.column = name;
        if (!result.ok)
            values.add(name, hint_on_values(paired(name, ours.values[*mine], chosen.values[c], match, result.object)));
        out.columns.push_back(result);
    }
    if (!out.ok()) {
        out.hints = values.lines();
        add_row_hints(ours, chosen, out.hints);
    }
    if (out.columns.empty() && out.mismatches.empty()) out.mismatches.emplace_back("no column was compared");
    return out;
}

}  // namespace type21
