#include "verification/criteria/cases/value_at.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "verification/results/compare/match_rows.h"

namespace type21 {
namespace {

double at_time(const CsvTable& rows, const std::vector<double>& values, double time) {
    const std::vector<double>& times = rows.time;
    const double tolerance = time_tolerance(times, times);
    for (size_t i = 0; i < times.size(); ++i)
        if (std::abs(times[i] - time) <= tolerance) return values[i];
    for (size_t i = 1; i < times.size(); ++i) {
        if (time < times[i - 1] || time > times[i]) continue;
        const double weight = (time - times[i - 1]) / (times[i] - times[i - 1]);
        return (1 - weight) * values[i - 1] + weight * values[i];
    }
    throw NoValue(
        fmt::format("{}: covers t = {:.9g} to {:.9g}, not {:.9g}", rows.file, times.front(), times.back(), time));
}

}  // namespace

double value_at(const CsvTable& table, const std::string& column, const At& at, std::optional<Id> object) {
    const std::optional<size_t> index = table.column(column);
    if (!index) throw NoValue(fmt::format("{}: has no column {}", table.file, column));
    if (table.has_object && !object) throw NoValue(fmt::format("{}: 'node' is needed to choose one", table.file));
    if (!table.has_object && object) throw NoValue(fmt::format("{}: has no nodes to choose from", table.file));
    const CsvTable rows = object ? filtered(table, {}, {*object}) : table;
    if (rows.rows() == 0)
        throw NoValue(object ? fmt::format("{}: object {} is not there", table.file, *object)
                             : fmt::format("{}: has no rows", table.file));
    const std::vector<double>& values = rows.values[*index];
    if (std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }))
        throw NoValue(fmt::format("{}: column {} holds a NaN", table.file, column));
    switch (at.kind) {
        case At::Kind::end:
            return values.back();
        case At::Kind::largest:
            return *std::max_element(values.begin(), values.end());
        case At::Kind::smallest:
            return *std::min_element(values.begin(), values.end());
        case At::Kind::time:
            break;
    }
    return at_time(rows, values, at.time);
}

}  // namespace type21
