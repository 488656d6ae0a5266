/// @file Reads fixed columns of a card: one place for blanks, overflow, text that is no number, units and their
/// messages.
#pragma once

#include <bitset>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/contract/mesh.h"
#include "reference/deck/deck.h"
#include "reference/model/units.h"

namespace type21 {

/// Columns count from 1 and are inclusive, as in the manual. Data lines count from 0. A line that the card does not
/// have, and columns beyond the end of a short line, read as blank; blank is 0. A word that is not a number is an error
/// and reads as 0.
class CardReader {
  public:
    CardReader(const Deck& deck, const Card& card, const UnitSystem& from, const UnitSystem& to, Problems& problems);

    size_t line_count() const;
    bool has_line(size_t line) const;
    bool blank(size_t line, int first, int last) const;
    /// Line of the deck for messages and origins; the keyword's when the card has no such data line.
    int line_number(size_t line) const;
    std::string file() const;
    /// "/IMPVEL/9": as the deck writes it.
    const std::string& keyword() const { return card_.keyword; }

    std::string text(size_t line, int first, int last) const;
    Id integer(size_t line, int first, int last, std::string_view field);
    /// Converted from the card's units to the work units.
    double real(size_t line, int first, int last, std::string_view field, Dimension dimension);
    /// The number as written, without conversion.
    double real_as_written(size_t line, int first, int last, std::string_view field);

    /// Fields that Radioss has and this program has no use for, `width` columns each: a word that is no number is an
    /// error, a number is nothing.
    void unused(size_t line, int first, int last, int width);
    /// Columns that another rule looks at, or text.
    void skip(size_t line, int first, int last) const;
    /// An error when the card has fewer data lines than these. Messages on lines that it does not have are dropped
    /// then.
    void need(const std::vector<std::string_view>& lines);
    /// Behind the last field: a warning for numbers in columns that no one asked for, an error for words there that are
    /// no number. Zeros, and comments that begin with '#', '$' or '!', are silent, and the title is text.
    void finish();

    const UnitSystem& from() const { return from_; }
    const UnitSystem& to() const { return to_; }

    /// line: data line of the card, or -1 for the keyword line. A field that could not be read at all has had its
    /// message: what is said of its value afterwards is dropped.
    void error(int line, std::string_view field, std::string value, std::string rule, std::string remedy);
    void warning(int line, std::string_view field, std::string value, std::string rule, std::string remedy);

  private:
    /// A number with non-blank characters on both sides of its field's border is most likely misplaced.
    void warn_if_cut(size_t line, int last, std::string_view field);
    void misread(size_t line, std::string_view field, std::string_view word, std::string rule, std::string remedy);
    void add(Problem problem, int line);
    void judge_unread(size_t line, int first, int last);

    const Deck& deck_;
    const Card& card_;
    const UnitSystem& from_;
    const UnitSystem& to_;
    Problems& problems_;
    static constexpr int card_columns = 100;
    mutable std::vector<std::bitset<card_columns + 2>> asked_;  ///< by line: columns that were asked for; 101: beyond
    bool line_0_is_title_ = true;
    bool ends_early_ = false;
    std::vector<std::pair<int, std::string>> misread_;  ///< line and field of every word that was no number
};

}  // namespace type21
