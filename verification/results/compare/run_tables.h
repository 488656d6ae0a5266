/// @file The histories of a run, each read once, and its unit system.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "reference/model/units.h"
#include "verification/results/tables/csv_table.h"

namespace type21 {

class RunTables {
  public:
    explicit RunTables(std::filesystem::path folder);

    const std::filesystem::path& folder() const { return folder_; }
    bool has(const std::string& file) const { return std::filesystem::exists(folder_ / file); }
    /// @param file  "interface_1.csv", "nodes.csv", "rbody.csv"
    /// @throws CsvError
    const CsvTable& table(const std::string& file);

    const std::set<Id>& interfaces() const { return interfaces_; }
    /// Of the interfaces, where run.json tells them.
    const std::map<Id, std::string>& titles() const { return titles_; }
    /// Ids in nodes.csv or rbody.csv; none without the file.
    const std::set<Id>& objects(const std::string& file);
    /// Columns of a file; none without the file.
    const std::vector<std::string>& columns(const std::string& file);
    /// Of the files, from run.json; nothing without it.
    const std::optional<UnitSystem>& units() const { return units_; }

  private:
    std::filesystem::path folder_;
    std::set<Id> interfaces_;
    std::map<Id, std::string> titles_;
    std::optional<UnitSystem> units_;
    std::map<std::string, CsvTable> tables_;
    std::map<std::string, std::set<Id>> objects_;
};

/// "interface_7.csv" of 7.
std::string interface_file(Id interface);
/// 7 of "interface_7.csv"; nothing for another name.
std::optional<Id> interface_of(std::string_view file);

}  // namespace type21
