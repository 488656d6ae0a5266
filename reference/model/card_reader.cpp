#include "reference/model/card_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/printable.h"
#include "reference/deck/text_file.h"
#include "reference/model/numbers.h"

namespace type21 {

namespace {

/// Columns first..last of a line, clipped to its length.
std::string_view columns(std::string_view line, int first, int last) {
    const auto begin = static_cast<std::size_t>(first - 1);
    if (begin >= line.size()) return {};
    return line.substr(begin, static_cast<std::size_t>(last) - begin);
}

/// The word that runs across the border behind column `last`; empty when none does. Full fields side by side (two ids
/// of ten digits) touch without being cut, so the right part must be shorter than the narrowest field.
std::string_view cut_word(std::string_view line, int last) {
    constexpr std::size_t narrowest = 10;
    const auto border = static_cast<std::size_t>(last);
    if (line.size() <= border || line[border - 1] == ' ' || line[border] == ' ') return {};
    const std::size_t end = std::min(line.find(' ', border), line.size());
    if (end - border >= narrowest) return {};
    const std::size_t blank = line.find_last_of(' ', border - 1);
    const std::size_t begin = blank == std::string_view::npos ? 0 : blank + 1;
    return line.substr(begin, end - begin);
}

/// True for a word that somebody meant as a number: it has a digit, or is a name of no finite number.
bool meant_as_number(std::string_view word) {
    const std::string name = upper(word);
    return word.find_first_of("0123456789") != std::string_view::npos || name == "NAN" || name == "INF";
}

Problem problem_of(Severity severity, const Card& card, std::string_view field, std::string value, std::string rule,
                   std::string remedy) {
    Problem problem;
    problem.severity = severity;
    problem.card = card.keyword;
    problem.field = std::string(field);
    problem.value = std::move(value);
    problem.rule = std::move(rule);
    problem.remedy = std::move(remedy);
    return problem;
}

}  // namespace

CardReader::CardReader(const Deck& deck, const Card& card, const UnitSystem& from, const UnitSystem& to,
                       Problems& problems)
    : deck_(deck), card_(card), from_(from), to_(to), problems_(problems) {}

size_t CardReader::line_count() const {
    return card_.lines.size();
}

bool CardReader::has_line(size_t line) const {
    return line < card_.lines.size();
}

bool CardReader::blank(size_t line, int first, int last) const {
    return !has_line(line) || trimmed(columns(card_.lines[line].text(), first, last)).empty();
}

int CardReader::line_number(size_t line) const {
    return has_line(line) ? card_.lines[line].number : card_.place.number;
}

std::string CardReader::file() const {
    return deck_.place(card_).file;
}

std::string CardReader::text(size_t line, int first, int last) const {
    if (!has_line(line)) return {};
    skip(line, first, last);
    return printable(trimmed(columns(card_.lines[line].text(), first, last)));
}

Id CardReader::integer(size_t line, int first, int last, std::string_view field) {
    skip(line, first, last);
    line_0_is_title_ = line_0_is_title_ && line != 0;
    if (blank(line, first, last)) return 0;
    const std::string_view word = trimmed(columns(card_.lines[line].text(), first, last));
    Id value = 0;
    const NumberFault fault = parse_integer(word, value);
    if (fault == NumberFault::not_an_integer) {
        misread(line, field, word, "an integer is asked for, this is a real number",
                "Write it without a decimal point");
    } else if (fault == NumberFault::out_of_range) {
        misread(line, field, word, "the integer does not fit into 64 bits", "Give a smaller number");
    } else if (fault == NumberFault::not_a_number) {
        misread(line, field, word, fmt::format("this is not a number (columns {} to {} are one integer)", first, last),
                "Give an integer, and keep it in its columns");
    } else {
        warn_if_cut(line, last, field);
    }
    return value;
}

double CardReader::real(size_t line, int first, int last, std::string_view field, Dimension dimension) {
    const double written = real_as_written(line, first, last, field);
    const double value = written * conversion(from_, to_, dimension);
    if (std::isfinite(value)) return value;
    misread(line, field, text(line, first, last),
            fmt::format("the number is not finite in the work units ({})", to_.name(dimension)),
            "Give a smaller number");
    return 0;
}

double CardReader::real_as_written(size_t line, int first, int last, std::string_view field) {
    skip(line, first, last);
    line_0_is_title_ = line_0_is_title_ && line != 0;
    if (blank(line, first, last)) return 0;
    const std::string_view word = trimmed(columns(card_.lines[line].text(), first, last));
    double value = 0;
    const NumberFault fault = parse_real(word, value);
    if (fault == NumberFault::out_of_range) {
        misread(line, field, word, "the number is beyond the range of double precision",
                "Give a number between 1e-307 and 1e307, or 0");
    } else if (fault != NumberFault::none) {
        misread(line, field, word,
                fmt::format("this is not a number (columns {} to {} are one real number)", first, last),
                "Give a number such as 1.5e-3, and keep it in its columns");
    } else {
        warn_if_cut(line, last, field);
    }
    return value;
}

void CardReader::unused(size_t line, int first, int last, int width) {
    for (int column = first; column <= last; column += width) {
        const int end = std::min(column + width - 1, last);
        double value = 0;
        skip(line, column, end);
        if (blank(line, column, end)) continue;
        const std::string_view word = trimmed(columns(card_.lines[line].text(), column, end));
        if (parse_real(word, value) != NumberFault::not_a_number) continue;
        error(static_cast<int>(line), fmt::format("columns {} to {}", column, end), std::string(word),
              "this is not a number", "Give a number, or leave the columns blank");
    }
}

void CardReader::skip(size_t line, int first, int last) const {
    if (!has_line(line)) return;
    if (asked_.size() <= line) asked_.resize(line + 1);
    auto& asked = asked_[line];
    for (int column = first; column <= std::min(last, card_columns + 1); ++column)
        asked.set(static_cast<size_t>(column));
}

void CardReader::need(const std::vector<std::string_view>& lines) {
    if (line_count() >= lines.size()) return;
    const auto counted = [](size_t count) { return fmt::format("{} data line{}", count, count == 1 ? "" : "s"); };
    error(-1, "", counted(line_count()),
          fmt::format("the card ends early: it needs {} ({})", counted(lines.size()), fmt::join(lines, "; ")),
          "Add the lines that are missing; a line whose fields are all unused is a blank line");
    ends_early_ = true;
}

void CardReader::finish() {
    const size_t lines = std::min(asked_.size(), line_count());
    for (size_t line = line_0_is_title_ ? 1 : 0; line < lines; ++line) {
        if (asked_[line].none()) continue;
        const auto end = static_cast<int>(std::min<size_t>(card_.lines[line].text().size(), card_columns + 1));
        for (int first = 1; first <= end; ++first) {
            if (asked_[line].test(static_cast<size_t>(first))) continue;
            int last = first;
            while (last < card_columns && !asked_[line].test(static_cast<size_t>(last) + 1))
                ++last;
            judge_unread(line, first, last);
            first = last;
        }
    }
}

void CardReader::judge_unread(size_t line, int first, int last) {
    const std::string_view text = card_.lines[line].text();
    std::string_view rest = first > card_columns ? text.substr(card_columns) : columns(text, first, last);
    const std::string_view cut = first > 1 ? cut_word(text, first - 1) : std::string_view{};
    if (!cut.empty()) rest.remove_prefix(std::min(rest.find(' '), rest.size()));  // that word has had its message
    rest = trimmed(rest);
    if (rest.empty() || rest.find_first_of("#$!") == 0) return;
    const std::string where =
        first > card_columns ? "columns beyond 100" : fmt::format("columns {} to {}", first, last);
    bool all_zero = true;
    for (std::string_view words = rest; !words.empty();) {
        const std::string_view word = words.substr(0, words.find(' '));
        words = trimmed(words.substr(word.size()));
        double value = 0;
        const bool number = parse_real(word, value) != NumberFault::not_a_number;
        all_zero = all_zero && number && value == 0;
        if (number || !meant_as_number(word)) continue;
        error(static_cast<int>(line), where, std::string(word),
              "this is not a number, and this line of the card has no field there", "Take it out");
        return;
    }
    if (all_zero) return;
    warning(static_cast<int>(line), where, std::string(rest), "are ignored: this line of the card has no field there",
            "Check that the numbers of the line stand in their columns");
}

void CardReader::warn_if_cut(size_t line, int last, std::string_view field) {
    const std::string_view word = cut_word(card_.lines[line].text(), last);
    if (word.empty()) return;
    warning(static_cast<int>(line), field, std::string(word),
            fmt::format("a word runs across the border behind column {} and is cut there", last),
            "Leave a blank between the fields, or move the number into its columns");
}

void CardReader::error(int line, std::string_view field, std::string value, std::string rule, std::string remedy) {
    add(problem_of(Severity::error, card_, field, std::move(value), std::move(rule), std::move(remedy)), line);
}

void CardReader::warning(int line, std::string_view field, std::string value, std::string rule, std::string remedy) {
    add(problem_of(Severity::warning, card_, field, std::move(value), std::move(rule), std::move(remedy)), line);
}

void CardReader::misread(size_t line, std::string_view field, std::string_view word, std::string rule,
                         std::string remedy) {
    const auto where = static_cast<int>(line);
    error(where, field, std::string(word), std::move(rule), std::move(remedy));
    constexpr size_t kept = 64;  // more fields than one check looks back at
    if (misread_.size() == kept) misread_.erase(misread_.begin(), misread_.begin() + kept / 2);
    misread_.emplace_back(where, field);
}

void CardReader::add(Problem problem, int line) {
    for (const auto& [misread_line, field] : misread_) {
        if (misread_line == line && field == problem.field) return;
    }
    const bool data = line >= 0 && has_line(static_cast<size_t>(line));
    if (ends_early_ && line >= 0 && line < std::numeric_limits<int>::max() && !data) return;
    problem.place = deck_.place(data ? card_.lines[static_cast<size_t>(line)] : card_.place);
    problems_.add(std::move(problem));
}

}  // namespace type21
