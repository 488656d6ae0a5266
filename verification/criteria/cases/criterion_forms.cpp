#include "verification/criteria/cases/criterion_forms.h"

#include <cmath>
#include <regex>

#include <fmt/format.h>

#include "verification/results/balance/balance.h"

namespace type21 {
namespace {

void require_file(TomlKeys& keys, std::string_view key, const std::filesystem::path& folder, const std::string& file) {
    if (!file.empty() && !std::filesystem::exists(folder / file))
        keys.complain(keys.line(key), fmt::format("{} is not in the case's folder", file));
}

std::string read_regex(TomlKeys& keys, std::string_view key) {
    const std::string text = keys.text(key);
    try {
        const std::regex trial(text);
    } catch (const std::regex_error& error) {
        keys.complain(keys.line(key), fmt::format("'{}' is not a regular expression: {}", text, error.what()));
    }
    return text;
}

At read_at(TomlKeys& keys) {
    const toml::node* node = keys.node("at");
    if (node && node->is_number()) return {At::Kind::time, node->value<double>().value_or(0)};
    const std::string text = node ? node->value_or(std::string()) : std::string();
    if (text == "max") return {At::Kind::largest, 0};
    if (text == "min") return {At::Kind::smallest, 0};
    if (text != "end") keys.complain(keys.line("at"), "'at' must be \"end\", \"max\", \"min\" or a time");
    return {};
}

/// A relative tolerance of a value that is 0 would allow nothing at all.
bool read_absolute(TomlKeys& keys, std::string_view key, double expected) {
    const bool absolute = keys.flag_or_false("absolute");
    if (!absolute && keys.has(key) && expected == 0)
        keys.complain(keys.line(key), fmt::format("'{}' is 0: the tolerance needs absolute = true", key));
    return absolute;
}

HistoryCriterion read_history(TomlKeys& keys, const std::filesystem::path& folder, const Criterion& criterion) {
    HistoryCriterion form;
    FileRule& rule = form.rule;
    rule.reference = keys.text("reference");
    require_file(keys, "reference", folder, rule.reference);
    rule.ours = keys.text_or("ours", our_name(rule.reference));
    rule.options.tolerance = criterion.tolerance;
    rule.options.columns = keys.texts("columns");
    rule.options.exclude = keys.texts("exclude");
    rule.options.objects = keys.integers("nodes");
    if (const auto from = keys.optional_number("from")) rule.options.window.from = *from;
    if (const auto until = keys.optional_number("until")) rule.options.window.until = *until;
    rule.label = fmt::format("criterion '{}'", criterion.id);
    rule.reason = criterion.reason;
    return form;
}

ValueCriterion read_value(TomlKeys& keys) {
    ValueCriterion form;
    form.file = keys.text("file");
    form.column = keys.text("column");
    form.at = read_at(keys);
    form.object = keys.optional_integer("node");
    form.expected = keys.number("expected");
    form.absolute = read_absolute(keys, "expected", form.expected);
    return form;
}

BalanceCriterion read_balance(TomlKeys& keys) {
    BalanceCriterion form{keys.text("balance"), keys.optional_integer("interface")};
    if (!form.quantity.empty() && !find_residual({}, form.quantity))
        keys.complain(keys.line("balance"),
                      "'balance' must be \"force\", \"power\", \"CE_DAMP\", \"CE_FRIC\" or \"heat\"");
    return form;
}

RefusalCriterion read_refusal(TomlKeys& keys) {
    if (keys.optional_integer("expect_exit") != 2)
        keys.complain(keys.line("expect_exit"), "'expect_exit' must be 2: the deck is refused");
    return {read_regex(keys, "message")};
}

DepartureCriterion read_departure(TomlKeys& keys, const std::filesystem::path& folder) {
    DepartureCriterion form;
    form.reference = keys.text("differs_from");
    require_file(keys, "differs_from", folder, form.reference);
    form.file = keys.text_or("file", our_name(form.reference));
    form.column = keys.text("column");
    form.at = read_at(keys);
    form.object = keys.optional_integer("node");
    form.by = keys.number("by");
    form.absolute = read_absolute(keys, "by", form.by);
    return form;
}

}  // namespace

void read_form(TomlKeys& keys, const std::filesystem::path& folder, Criterion& criterion) {
    const bool refusal = keys.has("expect_exit");
    const bool stop = keys.has("expect_stop");
    const bool history = keys.has("reference");
    const bool value = keys.has("expected");
    const bool balance = keys.has("balance");
    const bool departure = keys.has("differs_from");
    if (refusal + stop + history + value + balance + departure != 1) {
        keys.complain(
            keys.line(),
            "exactly one of reference, expected, balance, expect_exit, expect_stop and differs_from is needed");
    }
    if (refusal || stop) {
        criterion.reason = keys.text_or("reason", "");
    } else {
        criterion.reason = keys.text("reason");
        criterion.tolerance = keys.number("tolerance");
        if (!(criterion.tolerance >= 0) || std::isinf(criterion.tolerance))
            keys.complain(keys.line("tolerance"), "'tolerance' must be a finite number >= 0");
    }
    if (value || departure) criterion.unit = keys.text("unit");

    if (history)
        criterion.form = read_history(keys, folder, criterion);
    else if (departure)
        criterion.form = read_departure(keys, folder);
    else if (value)
        criterion.form = read_value(keys);
    else if (balance)
        criterion.form = read_balance(keys);
    else if (refusal)
        criterion.form = read_refusal(keys);
    else if (stop)
        criterion.form = StopCriterion{read_regex(keys, "expect_stop")};
}

}  // namespace type21
