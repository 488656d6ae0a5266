#include "verification/results/compare/compare_folders.h"

#include <algorithm>

#include <fmt/format.h>

namespace type21 {
namespace fs = std::filesystem;
namespace {

bool is_history(const std::string& name) {
    return name == "nodes.csv" || name == "tool.csv" || name == "rbody.csv" ||
           (name.starts_with("interface_") && name.ends_with(".csv"));
}

std::set<std::string> histories(const fs::path& folder) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (is_history(entry.path().filename().string())) names.insert(entry.path().filename().string());
    return names;
}

class FolderPair {
  public:
    FolderPair(const fs::path& ours, fs::path reference, const FolderOptions& options)
        : run_(ours), reference_(std::move(reference)), options_(options), changer_(options.changes, run_) {}

    FolderComparison compare() {
        const std::set<std::string> ours = histories(run_.folder());
        const std::set<std::string> reference = histories(reference_);
        std::set<std::string> used;
        for (const std::string& name : reference)
            compare_reference(name, ours, used);
        const bool two_runs = fs::exists(reference_ / "run.json");
        for (const std::string& name : ours) {
            if (used.contains(name)) continue;
            (two_runs ? out_.mismatches : out_.notes)
                .push_back(fmt::format("{}: only in {}", name, run_.folder().string()));
        }
        out_.nothing_in_common = out_.files.empty();
        if (out_.nothing_in_common && there_.empty()) return std::move(out_);
        require_columns(options_, found_columns_, there_);
        changer_.finish();
        return std::move(out_);
    }

  private:
    void compare_reference(const std::string& name, const std::set<std::string>& ours, std::set<std::string>& used) {
        try {
            CsvTable reference = read_csv(reference_ / name, {changer_.time_name(), true});
            changer_.rename(reference);
            for (FileRule& rule : rules_for(name, ours, reference)) {
                used.insert(rule.ours);
                if (!ours.contains(rule.ours)) {
                    out_.mismatches.push_back(
                        fmt::format("{}: missing ({} of the reference has no partner)", rule.ours, name));
                    continue;
                }
                changer_.require_targets(run_.columns(rule.ours), rule.ours);
                compare_file(rule, reference);
            }
        } catch (const CsvError& error) {
            out_.mismatches.emplace_back(error.what());
            used.insert(our_name(name));
        }
    }

    /// The rules for one reference file: the case's, or the default.
    std::vector<FileRule> rules_for(const std::string& name, const std::set<std::string>& ours,
                                    const CsvTable& reference) const {
        std::vector<FileRule> rules;
        for (const FileRule& rule : options_.rules)
            if (rule.reference == name) rules.push_back(rule);
        if (rules.empty())
            rules.push_back(default_rule(name, ours.contains(name) ? name : our_name(name), reference, options_));
        for (FileRule& rule : rules) {
            if (options_.tolerance) rule.options.tolerance = *options_.tolerance;
            // A column that is asked for by name is wanted whatever the rule leaves out.
            if (!options_.columns.empty()) rule.options.exclude.clear();
            if (options_.until) rule.options.window.until = std::min(rule.options.window.until, *options_.until);
            rule.options.shorter_reference = options_.shorter_reference;
        }
        return rules;
    }

    void compare_file(FileRule rule, CsvTable reference) {
        there_.insert(reference.columns.begin(), reference.columns.end());
        if (!options_.columns.empty()) {
            rule.options.columns.clear();
            for (const std::string& column : options_.columns)
                if (reference.column(column)) rule.options.columns.push_back(column);
            if (rule.options.columns.empty()) return;
            found_columns_.insert(rule.options.columns.begin(), rule.options.columns.end());
        }
        std::vector<std::string> notes = std::move(reference.notes);
        changer_.convert(reference, reference.columns, notes);
        TableResult table = compare_tables(run_.table(rule.ours), reference, rule.options);
        table.notes.insert(table.notes.begin(), notes.begin(), notes.end());
        out_.files.push_back({rule.reference, rule, std::move(table)});
    }

    RunTables run_;
    fs::path reference_;
    const FolderOptions& options_;
    ReferenceChanger changer_;
    std::set<std::string> found_columns_, there_;
    FolderComparison out_;
};

}  // namespace

FileRule default_rule(const std::string& name, const std::string& ours, const CsvTable& reference,
                      const FolderOptions& options) {
    FileRule rule{name, ours, {}, "", ""};
    rule.options.tolerance = options.tolerance.value_or(std::max(default_tolerance, 2 * reference.rounding));
    rule.options.shorter_reference = options.shorter_reference;
    if (options.until) rule.options.window.until = *options.until;
    if (options.tolerance || rule.options.tolerance == default_tolerance) return rule;
    rule.label = reference.rounded_to;
    rule.reason = "the tolerance is twice the rounding of the reference";
    return rule;
}

void require_columns(const FolderOptions& options, const std::set<std::string>& found,
                     const std::set<std::string>& there) {
    for (const std::string& column : options.columns)
        if (!found.contains(column))
            throw WrongOption(fmt::format("--columns: the reference has no column '{}'; it has {}", column,
                                          listed({there.begin(), there.end()})));
}

bool FolderComparison::ok() const {
    return mismatches.empty() && !files.empty() &&
           std::all_of(files.begin(), files.end(), [](const FileComparison& file) { return file.table.ok(); });
}

std::optional<FirstDifference> FolderComparison::first() const {
    std::optional<FirstDifference> earliest;
    for (const FileComparison& file : files)
        for (const ColumnResult& column : file.table.columns)
            if (column.first && (!earliest || column.first->time < earliest->difference.time))
                earliest = {file.name, column.column, *column.first};
    return earliest;
}

std::string our_name(const std::string& reference_name) {
    return reference_name == "tool.csv" ? "nodes.csv" : reference_name;
}

FolderComparison compare_folders(const fs::path& ours, const fs::path& reference, const FolderOptions& options) {
    return FolderPair(ours, reference, options).compare();
}

}  // namespace type21
