#include "verification/results/compare/comparison_text.h"

#include <cmath>

#include <fmt/format.h>

namespace type21 {
namespace {

using Json = nlohmann::ordered_json;

std::string column_line(const ColumnResult& column, bool objects) {
    const std::string object =
        objects ? fmt::format("{:>11}", column.object ? fmt::format("{}", *column.object) : "") : "";
    return fmt::format("  {:<9} {:>12.3e} {:>12.4e} {:>11.2e} {:>13.6e}{} {:>10.1e}  {}{}\n", column.column,
                       column.difference, column.scale, column.scaled, column.time, object, column.tolerance,
                       column.ok ? "ok" : "MISMATCH", column.remark.empty() ? "" : fmt::format(" ({})", column.remark));
}

std::string file_block(const FileComparison& file) {
    bool objects = false;
    for (const ColumnResult& column : file.table.columns)
        objects = objects || column.object.has_value();
    const std::string with = file.rule.ours == file.rule.reference ? "" : fmt::format(" with our {}", file.rule.ours);
    std::string out = fmt::format("{}{}: {} rows compared", file.name, with, file.table.rows);
    if (file.table.rows > 0)
        out += fmt::format(", t = {:.6g} to {:.6g}, {:.3g} % of the time of ours", file.table.coverage.from,
                           file.table.coverage.until, 100 * file.table.coverage.share);
    if (!file.rule.label.empty()) out += fmt::format(", {}: {}", file.rule.label, file.rule.reason);
    out += '\n';
    out += fmt::format("  {:<9} {:>12} {:>12} {:>11} {:>13}{} {:>10}  verdict\n", "column", "difference", "scale",
                       "scaled", "at time", objects ? fmt::format("{:>11}", "node") : "", "tolerance");
    for (const ColumnResult& column : file.table.columns)
        out += column_line(column, objects);
    for (const std::string& note : file.table.notes)
        out += fmt::format("  note: {}\n", note);
    for (const std::string& mismatch : file.table.mismatches)
        out += fmt::format("  MISMATCH: {}\n", mismatch);
    for (const std::string& hint : file.table.hints)
        out += fmt::format("  hint: {}\n", hint);
    return out;
}

Json number(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    return value;
}

Json difference_json(const Difference& difference) {
    Json json = {
        {"time", difference.time}, {"ours", number(difference.ours)}, {"reference", number(difference.reference)}};
    if (difference.object) json["node"] = *difference.object;
    return json;
}

Json column_json(const ColumnResult& column) {
    Json json = {{"column", column.column},
                 {"difference", number(column.difference)},
                 {"scale", number(column.scale)},
                 {"scaled", number(column.scaled)},
                 {"time", column.time},
                 {"ours", number(column.ours)},
                 {"reference", number(column.reference)},
                 {"tolerance", column.tolerance},
                 {"verdict", column.ok ? "ok" : "mismatch"}};
    if (column.first) json["first"] = difference_json(*column.first);
    if (column.object) json["node"] = *column.object;
    if (!column.remark.empty()) json["remark"] = column.remark;
    return json;
}

}  // namespace

std::string to_text(const FolderComparison& comparison) {
    std::string out;
    for (const FileComparison& file : comparison.files)
        out += file_block(file);
    for (const std::string& note : comparison.notes)
        out += fmt::format("note: {}\n", note);
    for (const std::string& mismatch : comparison.mismatches)
        out += fmt::format("MISMATCH: {}\n", mismatch);
    for (const std::string& hint : comparison.hints)
        out += fmt::format("hint: {}\n", hint);
    if (comparison.nothing_in_common)
        return out + "Nothing in common: the folders have no history that could be compared\n";
    const FileComparison* worst = nullptr;
    for (const FileComparison& file : comparison.files)
        if (file.table.worst() && (!worst || file.table.worst()->scaled > worst->table.worst()->scaled)) worst = &file;
    if (worst)
        out += fmt::format("largest scaled difference {:.2e} ({} of {})\n", worst->table.worst()->scaled,
                           worst->table.worst()->column, worst->name);
    if (const auto first = comparison.first())
        out += fmt::format(
            "first difference above its tolerance at t = {:.9g}: {}{} of {}, ours {:.9g}, reference {:.9g}\n",
            first->difference.time, first->column,
            first->difference.object ? fmt::format(" of node {}", *first->difference.object) : "", first->file,
            first->difference.ours, first->difference.reference);
    return out + (comparison.ok() ? "agree\n" : "DIFFER\n");
}

Json to_json(const FolderComparison& comparison) {
    Json files = Json::array();
    for (const FileComparison& file : comparison.files) {
        Json columns = Json::array();
        for (const ColumnResult& column : file.table.columns)
            columns.push_back(column_json(column));
        files.push_back({{"file", file.name},
                         {"ours", file.rule.ours},
                         {"rule", file.rule.label},
                         {"reason", file.rule.reason},
                         {"rows", file.table.rows},
                         {"covered",
                          {{"from", file.table.coverage.from},
                           {"until", file.table.coverage.until},
                           {"share", file.table.coverage.share}}},
                         {"columns", columns},
                         {"notes", file.table.notes},
                         {"mismatches", file.table.mismatches},
                         {"hints", file.table.hints}});
    }
    Json first;
    if (const auto difference = comparison.first()) {
        first = difference_json(difference->difference);
        first["file"] = difference->file;
        first["column"] = difference->column;
    }
    return {{"verdict", comparison.ok() ? "agree" : "differ"},
            {"nothing_in_common", comparison.nothing_in_common},
            {"first_difference", first},
            {"files", files},
            {"notes", comparison.notes},
            {"mismatches", comparison.mismatches},
            {"hints", comparison.hints}};
}

}  // namespace type21
