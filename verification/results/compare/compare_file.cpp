#include "verification/results/compare/compare_file.h"

#include <fmt/format.h>

#include "verification/results/compare/hints.h"

namespace type21 {
namespace fs = std::filesystem;

FolderComparison compare_file(const fs::path& ours, const fs::path& reference, const FolderOptions& options) {
    RunTables run(ours);
    ReferenceChanger changer(options.changes, run);
    const T01Tables tables = reference_tables(reference, run, changer);
    changer.finish();
    FolderComparison out;
    out.notes = tables.notes;
    std::set<std::string> used, found, there;
    bool whole_model = false;
    for (const T01Table& table : tables.tables) {
        FileRule rule = default_rule(table.name, table.ours, table.table, options);
        there.insert(table.table.columns.begin(), table.table.columns.end());
        for (const std::string& column : options.columns)
            if (table.table.column(column)) rule.options.columns.push_back(column);
        found.insert(rule.options.columns.begin(), rule.options.columns.end());
        used.insert(table.ours);
        whole_model = whole_model || table.name != reference.filename().string();
        if (!options.columns.empty() && rule.options.columns.empty()) continue;
        if (!run.has(table.ours)) {
            out.mismatches.push_back(fmt::format("{}: missing ({} has no partner)", table.ours, table.name));
            if (const std::string hint = hint_on_interface(table.ours, run.interfaces()); !hint.empty())
                out.hints.push_back(hint);
            continue;
        }
        out.files.push_back({table.name, rule, compare_tables(run.table(table.ours), table.table, rule.options)});
    }
    require_columns(options, found, there);
    for (const Id interface : run.interfaces())
        if (whole_model && !used.contains(interface_file(interface)))
            out.notes.push_back(fmt::format("{}: only in {}", interface_file(interface), ours.string()));
    out.nothing_in_common = out.files.empty();
    return out;
}

}  // namespace type21
