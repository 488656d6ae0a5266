#include "verification/results/compare/compare_file.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "verification/results/t01/t01_tables.h"

namespace type21 {
namespace fs = std::filesystem;
namespace {

bool is_interface(const std::string& name) {
    return name.starts_with("interface_") && name.ends_with(".csv");
}

std::vector<std::string> interface_files(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (is_interface(entry.path().filename().string())) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string partner_of(const CsvTable& table, const fs::path& reference, const fs::path& ours) {
    if (table.has_object) return table.object_name == "node" ? "nodes.csv" : table.object_name + ".csv";
    std::string name = reference.filename().string();
    if (is_interface(name)) return name;
    const std::vector<std::string> interfaces = interface_files(ours);
    if (interfaces.size() == 1) return interfaces.front();
    throw UnclearReference(
        fmt::format("{}: {} has {} interfaces and the name does not say which this is. Name it "
                    "interface_<id>.csv",
                    reference.string(), ours.string(), interfaces.size()));
}

T01Tables tables_in(const fs::path& reference, const fs::path& ours) {
    if (reference.extension() != ".csv") return tables_of(read_t01(reference));
    T01Tables out;
    CsvTable table = read_csv(reference);
    const std::string partner = partner_of(table, reference, ours);
    out.tables.push_back({reference.filename().string(), partner, std::move(table)});
    return out;
}

CompareOptions options_for(const CsvTable& reference, const FolderOptions& options) {
    CompareOptions out;
    out.tolerance = options.tolerance.value_or(std::max(default_tolerance, 2 * reference.rounding));
    for (const std::string& column : options.columns)
        if (reference.column(column)) out.columns.push_back(column);
    return out;
}

}  // namespace

FolderComparison compare_file(const fs::path& ours, const fs::path& reference, const FolderOptions& options) {
    FolderComparison out;
    const T01Tables tables = tables_in(reference, ours);
    out.notes = tables.notes;
    std::set<std::string> used, found;
    for (const T01Table& table : tables.tables) {
        const CompareOptions chosen = options_for(table.table, options);
        found.insert(chosen.columns.begin(), chosen.columns.end());
        used.insert(table.ours);
        if (!options.columns.empty() && chosen.columns.empty()) continue;
        if (!fs::exists(ours / table.ours)) {
            out.mismatches.push_back(fmt::format("{}: missing ({} has no partner)", table.ours, table.name));
            continue;
        }
        const bool is_single = table.table.rounding > 0;
        const FileRule rule{table.name, table.ours, chosen, is_single ? "single precision" : "",
                            is_single ? "its floats hold 24 bits" : ""};
        out.files.push_back({table.name, rule, compare_tables(read_csv(ours / table.ours), table.table, chosen)});
    }
    for (const std::string& name : interface_files(ours))
        if (!used.contains(name) && reference.extension() != ".csv")
            out.notes.push_back(fmt::format("{}: only in {}", name, ours.string()));
    for (const std::string& column : options.columns)
        if (!found.contains(column)) out.mismatches.push_back(fmt::format("column {} is not in the reference", column));
    out.nothing_in_common = out.files.empty();
    return out;
}

}  // namespace type21
