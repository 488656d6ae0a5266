/// @file Compares two result folders, or a result folder and the measured histories of a case.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "verification/results/compare/compare_tables.h"
#include "verification/results/compare/reference_changes.h"

namespace type21 {

/// How a case compares one of its files.
struct FileRule {
    std::string reference;  ///< file name in the second folder
    std::string ours;       ///< file name in the first folder
    CompareOptions options;
    std::string label;   ///< "criterion 'interface'"
    std::string reason;  ///< for its tolerance and exclusions
};

struct FolderOptions {
    std::optional<double> tolerance;   ///< overrides every rule
    std::vector<std::string> columns;  ///< only these, in whichever file has them
    std::vector<FileRule> rules;       ///< files without a rule are compared with the defaults
    ReferenceChanges changes{};
    std::optional<double> until{};  ///< rows after it do not count [time]
    bool shorter_reference = true;  ///< CompareOptions::shorter_reference of every file
};

struct FileComparison {
    std::string name;  ///< of the reference file
    FileRule rule;
    TableResult table;
};

/// The earliest difference above its tolerance, and where it is.
struct FirstDifference {
    std::string file, column;
    Difference difference;
};

struct FolderComparison {
    std::vector<FileComparison> files;
    std::vector<std::string> notes;
    std::vector<std::string> mismatches;  ///< missing or unreadable files
    std::vector<std::string> hints{};     ///< what may be behind them
    bool nothing_in_common = false;

    bool ok() const;
    /// The earliest difference above its tolerance, of the first file that has it.
    std::optional<FirstDifference> first() const;
};

/// Options of a file without a rule of its own: the tolerance of the command, else default_tolerance, or twice the
/// rounding of the reference where that is more.
FileRule default_rule(const std::string& name, const std::string& ours, const CsvTable& reference,
                      const FolderOptions& options);
/// @throws WrongOption for a column of `options` that is not in `found`
void require_columns(const FolderOptions& options, const std::set<std::string>& found,
                     const std::set<std::string>& there);

/// "nodes.csv" for "tool.csv": the tool's nodes are in the one file that a run writes. Otherwise the same name.
std::string our_name(const std::string& reference_name);

/// Pairs interface_*.csv, nodes.csv and rbody.csv by name; tool.csv of a case pairs with our nodes.csv. A file that
/// only `ours` has is a mismatch if the reference is a result folder, too (it has a run.json), and a note if it is a
/// case.
/// @throws WrongOption when an option names a column that no file has
FolderComparison compare_folders(const std::filesystem::path& ours, const std::filesystem::path& reference,
                                 const FolderOptions& options);

}  // namespace type21
