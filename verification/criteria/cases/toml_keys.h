/// @file The keys of one TOML table, each asked for by type; keys that were not asked for are unknown.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "reference/contract/mesh.h"

namespace type21 {

/// Reads keys and collects complaints with file and line. A missing key reads as empty or 0.
class TomlKeys {
  public:
    /// @param where  what the table is, for messages: "[[criterion]] 'interface'"
    TomlKeys(const toml::table& table, std::string file, std::string where, std::vector<std::string>& problems);

    bool has(std::string_view key) const { return table_.contains(key); }
    int line() const { return line_; }
    /// Line of a key's value, that of the table when it is not there.
    int line(std::string_view key) const;

    std::string text(std::string_view key);
    std::string text_or(std::string_view key, const std::string& fallback);
    double number(std::string_view key);
    std::optional<double> optional_number(std::string_view key);
    std::optional<Id> optional_integer(std::string_view key);
    bool flag_or_false(std::string_view key);
    std::vector<std::string> texts(std::string_view key);
    std::vector<Id> integers(std::string_view key);
    /// The table entries of an array of tables; the array must be there and not empty.
    std::vector<const toml::table*> tables(std::string_view key);
    /// The raw value, for a key of several types; nullptr when missing.
    const toml::node* node(std::string_view key);

    void complain(int line, const std::string& what);
    /// Adds a complaint for each key that was not asked for.
    void finish();

  private:
    const toml::node* require(std::string_view key);
    void wrong_type(std::string_view key, std::string_view wanted);

    const toml::table& table_;
    std::string file_, where_;
    int line_;
    std::vector<std::string>& problems_;
    std::set<std::string, std::less<>> used_;
};

}  // namespace type21
