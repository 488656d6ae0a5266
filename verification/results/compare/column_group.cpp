#include "verification/results/compare/column_group.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace type21 {
namespace {

constexpr double group_floor = 1e-3;

bool is_axis(std::string_view text) {
    return text == "X" || text == "Y" || text == "Z";
}

double largest_of(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest;
}

/// "VRX" with the prefix "VR": true.
bool is_component(std::string_view column, std::string_view prefix) {
    return column.starts_with(prefix) && is_axis(column.substr(prefix.size()));
}

}  // namespace

std::string unit_group(std::string_view column) {
    if (column.starts_with('|') || is_component(column, "FN") || is_component(column, "FT") ||
        is_component(column, "F"))
        return "impulse";
    if (column == "QFRIC" || column.starts_with("CE_")) return "energy";
    if (is_component(column, "D") || is_axis(column)) return "length";
    if (is_component(column, "V")) return "velocity";
    if (is_component(column, "A")) return "acceleration";
    if (is_component(column, "VR")) return "angular velocity";
    if (is_component(column, "REAC")) return "reaction";
    if (column == "REACXX" || column == "REACYY" || column == "REACZZ") return "reaction moment";
    if (is_component(column, "M")) return "moment impulse";
    return std::string(column);
}

std::vector<double> column_scales(const CsvTable& reference, const CsvTable& ours, double tolerance) {
    std::vector<double> scales;
    std::map<std::string, double> group_largest;
    for (size_t c = 0; c < reference.columns.size(); ++c) {
        scales.push_back(largest_of(reference.values[c]));
        double& group = group_largest[unit_group(reference.columns[c])];
        group = std::max(group, scales.back());
    }
    for (size_t c = 0; c < scales.size(); ++c) {
        const double group = group_largest[unit_group(reference.columns[c])];
        const std::optional<size_t> mine = ours.column(reference.columns[c]);
        const double largest = std::max(scales[c], mine ? largest_of(ours.values[*mine]) : 0.0);
        scales[c] =
            largest <= std::min(tolerance, group_floor) * group ? group : std::max(scales[c], group_floor * group);
    }
    return scales;
}

}  // namespace type21
