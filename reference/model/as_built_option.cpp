#include "reference/model/as_built_option.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace type21 {
namespace {

std::string trimmed_upper(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return "";
    std::string out(text.substr(first, text.find_last_not_of(" \t") - first + 1));
    std::transform(out.begin(), out.end(), out.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return out;
}

/// The row of "D03", or none.
const DepartureRow* find_row(std::string_view word) {
    for (const DepartureRow& row : departures())
        if (name(row.id) == word) return &row;
    return nullptr;
}

std::string valid_names() {
    return AsBuilt::all().text();
}

void complain(Problems& problems, const std::string& word, std::string rule) {
    Problem problem;
    problem.card = "--as-built";
    problem.value = word;
    problem.rule = std::move(rule);
    problem.remedy = fmt::format(
        "Give none, all, or names separated by commas, '-' takes one away (all,-D04). Available: {}", valid_names());
    problems.add(std::move(problem));
}

}  // namespace

AsBuilt parse_as_built(const std::string& text, Problems& problems) {
    AsBuilt set;
    if (trimmed_upper(text).empty()) return set;
    size_t begin = 0;
    while (begin <= text.size()) {
        const size_t comma = std::min(text.find(',', begin), text.size());
        const std::string word = trimmed_upper(std::string_view(text).substr(begin, comma - begin));
        begin = comma + 1;
        if (word == "ALL") {
            set = AsBuilt::all();
            continue;
        }
        if (word == "NONE") {
            set = AsBuilt{};
            continue;
        }
        const bool take_away = word.starts_with('-');
        const DepartureRow* row = find_row(trimmed_upper(take_away ? std::string_view(word).substr(1) : word));
        if (row == nullptr) {
            complain(problems, word, "is not the name of a departure");
        } else if (!row->available) {
            complain(problems, word, fmt::format("is not available: {}", row->reason));
        } else if (take_away && !set.has(row->id)) {
            complain(problems, word, "takes away a departure that is not in the set so far");
        } else {
            set.set(row->id, !take_away);
        }
    }
    return set;
}

}  // namespace type21
