#include "reference/deck/problem.h"

#include <utility>

#include <fmt/format.h>

#include "reference/deck/printable.h"

namespace type21 {

namespace {

/// After this many values of one field that break one rule, the others share a message: a deck with every column
/// shifted must not give a message for each of its lines.
constexpr int max_values = 20;

/// Distinct problems of one severity that are kept; the others share one message. Nobody reads more.
constexpr int max_problems = 500;

/// A value, rule or remedy is shown up to this length: a line of a deck may have 1000 characters, a path more.
constexpr std::size_t max_text = 300;

const char* const more_than_shown = "more problems than are shown here";

/// What makes two problems the same: everything but the place and, for the second key, the value.
std::string key_of(const Problem& p, const std::string& value) {
    const char separator = '\x1f';
    return fmt::format("{1}{0}{2}{0}{3}{0}{4}{0}{5}{0}{6}", separator, p.severity == Severity::error, p.card, p.field,
                       value, p.rule, p.remedy);
}

}  // namespace

void Problems::add(Problem problem) {
    for (std::string* text : {&problem.card, &problem.field, &problem.value, &problem.rule, &problem.remedy})
        *text = printable(*text, max_text);
    const std::string kind = key_of(problem, "\x1e");
    std::string key = key_of(problem, problem.value);
    auto met = index_.find(key);
    if (met == index_.end() && values_[kind] >= max_values) {
        problem.value = "(other values)";
        key = key_of(problem, problem.value);
        met = index_.find(key);
    }
    if (met != index_.end()) {
        list_[met->second].count += problem.count;
        return;
    }
    int& kept = problem.severity == Severity::error ? errors_ : warnings_;
    if (kept >= max_problems) {
        problem.card = problem.field = problem.value = "";
        problem.rule = more_than_shown;
        problem.remedy = "Mend those that are shown first";
        key = key_of(problem, problem.value);
        if (const auto rest = index_.find(key); rest != index_.end()) {
            list_[rest->second].count += problem.count;
            return;
        }
    } else {
        ++values_[kind];
        ++kept;
    }
    index_.emplace(std::move(key), list_.size());
    list_.push_back(std::move(problem));
}

int Problems::error_count() const {
    int count = 0;
    for (const Problem& p : list_)
        count += p.severity == Severity::error ? 1 : 0;
    return count;
}

int Problems::warning_count() const {
    return static_cast<int>(list_.size()) - error_count();
}

bool Problems::has_errors() const {
    return error_count() > 0;
}

std::string to_text(const Problem& problem) {
    std::string text = printable(problem.place.file);
    if (problem.place.line > 0) text += fmt::format(":{}", problem.place.line);
    text += problem.severity == Severity::error ? ": error: " : ": warning: ";
    std::string subject = problem.card;
    if (!problem.field.empty()) subject += fmt::format("{}field '{}'", subject.empty() ? "" : ", ", problem.field);
    if (!problem.value.empty()) {
        const char* before = !problem.field.empty() ? " = " : subject.empty() ? "" : " ";
        subject += before + problem.value;
    }
    if (!subject.empty()) text += subject + ": ";
    text += problem.rule;
    if (!problem.remedy.empty()) text += ". " + problem.remedy;
    if (problem.count > 1) text += fmt::format(" ({} times; this is the first)", problem.count);
    return text;
}

}  // namespace type21
