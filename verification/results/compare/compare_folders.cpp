#include "verification/results/compare/compare_folders.h"

#include <algorithm>
#include <set>

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

/// The rules for one reference file: the case's, or the default.
std::vector<FileRule> rules_for(const std::string& name, const std::set<std::string>& ours,
                                const FolderOptions& options) {
    std::vector<FileRule> rules;
    for (const FileRule& rule : options.rules)
        if (rule.reference == name) rules.push_back(rule);
    if (rules.empty()) rules.push_back({name, ours.contains(name) ? name : our_name(name), {}, "", ""});
    for (FileRule& rule : rules) {
        if (options.tolerance) rule.options.tolerance = *options.tolerance;
        // A column that is asked for by name is wanted whatever the rule leaves out.
        if (!options.columns.empty()) rule.options.exclude.clear();
    }
    return rules;
}

class FolderPair {
  public:
    FolderPair(fs::path ours, fs::path reference, const FolderOptions& options)
        : ours_(std::move(ours)), reference_(std::move(reference)), options_(options) {}

    FolderComparison compare() {
        const std::set<std::string> ours = histories(ours_);
        const std::set<std::string> reference = histories(reference_);
        std::set<std::string> used;
        for (const std::string& name : reference) {
            for (const FileRule& rule : rules_for(name, ours, options_)) {
                used.insert(rule.ours);
                if (ours.contains(rule.ours)) {
                    compare_file(rule);
                } else {
                    out_.mismatches.push_back(
                        fmt::format("{}: missing ({} of the reference has no partner)", rule.ours, name));
                }
            }
        }
        const bool two_runs = fs::exists(reference_ / "run.json");
        for (const std::string& name : ours) {
            if (used.contains(name)) continue;
            (two_runs ? out_.mismatches : out_.notes).push_back(fmt::format("{}: only in {}", name, ours_.string()));
        }
        for (const std::string& column : options_.columns)
            if (!found_columns_.contains(column))
                out_.mismatches.push_back(fmt::format("column {} is in no file", column));
        out_.nothing_in_common = out_.files.empty();
        return std::move(out_);
    }

  private:
    void compare_file(FileRule rule) {
        try {
            const CsvTable ours = read_csv(ours_ / rule.ours);
            const CsvTable reference = read_csv(reference_ / rule.reference);
            if (!options_.columns.empty()) {
                rule.options.columns.clear();
                for (const std::string& column : options_.columns)
                    if (reference.column(column)) rule.options.columns.push_back(column);
                if (rule.options.columns.empty()) return;
                found_columns_.insert(rule.options.columns.begin(), rule.options.columns.end());
            }
            out_.files.push_back({rule.reference, rule, compare_tables(ours, reference, rule.options)});
        } catch (const CsvError& error) {
            out_.mismatches.emplace_back(error.what());
        }
    }

    fs::path ours_, reference_;
    const FolderOptions& options_;
    std::set<std::string> found_columns_;
    FolderComparison out_;
};

}  // namespace

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
