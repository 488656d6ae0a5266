/// @file The text of a CSV as RFC 4180 has it, and as spreadsheets and numpy write it: lines, cells, separators.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace type21 {

/// The file is not a history: the message has file and line. Exit code 2.
struct CsvError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// One row: the number of its first line in the file, from 1, and its cells, without quotes and outer blanks. They are
/// valid until the next row.
using CsvRow = std::function<void(std::size_t line, std::span<const std::string_view> cells)>;

/// The cells of a text.
///
/// Blank lines and lines that begin with # are passed over; a byte-order mark and the line `sep=;` of a spreadsheet at
/// the beginning, too. A line ends with LF, CRLF or CR. A cell in double quotes may hold separators, line ends and
/// doubled quotes.
class CsvText {
  public:
    /// @param text  is referred to
    /// @param file  for messages
    /// @throws CsvError when the text is empty, is UTF-16, or has bytes that no text has
    CsvText(std::string_view text, std::string file);

    /// ';', tab or ','. The first of them that is outside the quotes of the header.
    char separator() const { return separator_; }
    /// The header is a comment, as numpy.savetxt writes it: `# time,FNX`.
    bool header_in_comment() const { return header_in_comment_; }
    /// Every row, the header first. @throws CsvError when a quote is not closed, or what the row throws
    void each_row(const CsvRow& row) const;

  private:
    std::string_view text_;
    std::string file_;
    std::string_view header_;  ///< of a header in a comment
    std::size_t header_line_ = 0;
    char separator_ = ',';
    bool header_in_comment_ = false;
};

}  // namespace type21
