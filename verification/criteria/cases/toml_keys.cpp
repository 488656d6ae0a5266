#include "verification/criteria/cases/toml_keys.h"

#include <fmt/format.h>

namespace type21 {
namespace {

int line_of(const toml::node& node) {
    return static_cast<int>(node.source().begin.line);
}

}  // namespace

TomlKeys::TomlKeys(const toml::table& table, std::string file, std::string where, std::vector<std::string>& problems)
    : table_(table), file_(std::move(file)), where_(std::move(where)), line_(line_of(table)), problems_(problems) {}

int TomlKeys::line(std::string_view key) const {
    const toml::node* found = table_.get(key);
    return found ? line_of(*found) : line_;
}

void TomlKeys::complain(int line, const std::string& what) {
    problems_.push_back(fmt::format("{}:{}: {}: {}", file_, line, where_, what));
}

const toml::node* TomlKeys::node(std::string_view key) {
    used_.emplace(key);
    return table_.get(key);
}

const toml::node* TomlKeys::require(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) complain(line_, fmt::format("key '{}' is missing", key));
    return found;
}

void TomlKeys::wrong_type(std::string_view key, std::string_view wanted) {
    complain(line(key), fmt::format("'{}' must be {}", key, wanted));
}

std::string TomlKeys::text(std::string_view key) {
    const toml::node* found = require(key);
    if (!found) return "";
    if (const auto value = found->value_exact<std::string>(); value && !value->empty()) return *value;
    wrong_type(key, "a text that is not empty");
    return "";
}

std::string TomlKeys::text_or(std::string_view key, const std::string& fallback) {
    const toml::node* found = node(key);
    if (!found) return fallback;
    if (const auto value = found->value_exact<std::string>()) return *value;
    wrong_type(key, "a text");
    return fallback;
}

double TomlKeys::number(std::string_view key) {
    if (!require(key)) return 0;
    return optional_number(key).value_or(0);
}

std::optional<double> TomlKeys::optional_number(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    if (found->is_number()) return found->value<double>();
    wrong_type(key, "a number");
    return std::nullopt;
}

std::optional<Id> TomlKeys::optional_integer(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return std::nullopt;
    if (const auto value = found->value_exact<int64_t>()) return *value;
    wrong_type(key, "a whole number");
    return std::nullopt;
}

bool TomlKeys::flag_or_false(std::string_view key) {
    const toml::node* found = node(key);
    if (!found) return false;
    if (const auto value = found->value_exact<bool>()) return *value;
    wrong_type(key, "true or false");
    return false;
}

std::vector<std::string> TomlKeys::texts(std::string_view key) {
    std::vector<std::string> out;
    const toml::node* found = node(key);
    if (!found) return out;
    const toml::array* list = found->as_array();
    if (!list) wrong_type(key, "a list of texts");
    for (size_t i = 0; list && i < list->size(); ++i) {
        const auto value = (*list)[i].value_exact<std::string>();
        if (value) {
            out.push_back(*value);
        } else {
            wrong_type(key, "a list of texts");
        }
    }
    return out;
}

std::vector<Id> TomlKeys::integers(std::string_view key) {
    std::vector<Id> out;
    const toml::node* found = node(key);
    if (!found) return out;
    const toml::array* list = found->as_array();
    if (!list) wrong_type(key, "a list of whole numbers");
    for (size_t i = 0; list && i < list->size(); ++i) {
        const auto value = (*list)[i].value_exact<int64_t>();
        if (value) {
            out.push_back(*value);
        } else {
            wrong_type(key, "a list of whole numbers");
        }
    }
    return out;
}

std::vector<const toml::table*> TomlKeys::tables(std::string_view key) {
    std::vector<const toml::table*> out;
    const toml::node* found = node(key);
    const toml::array* list = found ? found->as_array() : nullptr;
    if (!list || list->empty() || !list->is_array_of_tables()) {
        complain(line(key), fmt::format("at least one [[{}]] is needed", key));
        return out;
    }
    for (const toml::node& entry : *list)
        out.push_back(entry.as_table());
    return out;
}

void TomlKeys::finish() {
    for (const auto& [key, value] : table_)
        if (!used_.contains(key.str())) complain(line_of(value), fmt::format("unknown key '{}'", key.str()));
}

}  // namespace type21
