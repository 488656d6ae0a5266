#include "reference/model/card_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

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
    return !has_line(line) || trimmed(columns(card_.lines[line].text, first, last)).empty();
}

int CardReader::line_number(size_t line) const {
    return has_line(line) ? card_.lines[line].number : card_.place.number;
}

std::string CardReader::file() const {
    return deck_.place(card_).file;
}

std::string CardReader::text(size_t line, int first, int last) const {
    if (!has_line(line)) return {};
    return std::string(trimmed(columns(card_.lines[line].text, first, last)));
}

Id CardReader::integer(size_t line, int first, int last, std::string_view field) {
    if (blank(line, first, last)) return 0;
    const std::string_view word = trimmed(columns(card_.lines[line].text, first, last));
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
    if (blank(line, first, last)) return 0;
    const std::string_view word = trimmed(columns(card_.lines[line].text, first, last));
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

void CardReader::warn_if_cut(size_t line, int last, std::string_view field) {
    const std::string_view word = cut_word(card_.lines[line].text, last);
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
    problem.place = deck_.place(data ? card_.lines[static_cast<size_t>(line)] : card_.place);
    problems_.add(std::move(problem));
}

}  // namespace type21
