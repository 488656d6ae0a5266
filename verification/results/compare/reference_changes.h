/// @file What is done to a reference before it is compared: names, factors, units.
#pragma once

#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "verification/results/compare/run_tables.h"

namespace type21 {

/// An option names something that is not there; the message lists what is. Exit code 1.
struct WrongOption : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ReferenceChanges {
    /// Our column, maybe with its file or object ("FNX", "interface_1:FNX", "node_1012:DZ", "time"), and the header of
    /// the reference that stands for it.
    std::vector<std::pair<std::string, std::string>> map{};
    std::vector<std::pair<std::string, double>> scale{};  ///< column, by our name or the reference's, and factor [-]
    std::optional<double> time_scale{};                   ///< factor of the times [-]
};

/// Applies the changes to one table after the other, and knows at the end which of them found nothing to change.
class ReferenceChanger {
  public:
    ReferenceChanger(const ReferenceChanges& changes, const RunTables& run) : changes_(changes), run_(run) {}

    /// How the times are called in the reference.
    std::string time_name() const;
    /// What --map says about a header: the whole one, or the name without its unit. Empty where it says nothing.
    std::string mapped(const std::string& column, const std::string& unit);
    /// Renames the columns that --map names.
    void rename(CsvTable& table);
    /// @param columns  of our file
    /// @throws WrongOption where --map has used a name that our file does not have
    void require_targets(const std::vector<std::string>& columns, const std::string& file) const;
    /// Times and values into the units of ours. A unit that the header names is converted where run.json tells ours; a
    /// factor of an option replaces that.
    /// @param names  our name of each column; empty for a column that is left out
    /// @param notes  what was done
    void convert(CsvTable& table, const std::vector<std::string>& names, std::vector<std::string>& notes);
    /// @throws WrongOption for a name of --map or --scale that was in no table
    void finish() const;

  private:
    void convert_times(CsvTable& table, std::vector<std::string>& notes);
    double factor_of(const CsvTable& table, size_t column, const std::string& name, std::vector<std::string>& notes);

    const ReferenceChanges& changes_;
    const RunTables& run_;
    std::set<std::string> used_, seen_;
};

/// "a, b, c and 12 more" of a list.
std::string listed(const std::vector<std::string>& names);

}  // namespace type21
