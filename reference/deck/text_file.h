/// @file One text file of a deck as lines, whatever editor wrote it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/deck/problem.h"

namespace type21 {

/// Columns between two tab stops. Radioss fields are 10 or 20 wide, so a tab leads to the start of a field.
inline constexpr std::size_t tab_stop = 10;

/// A file larger than this, or a deck whose files together are, is refused: it is no deck.
inline constexpr std::size_t max_bytes = std::size_t{2} << 30;

/// The text of a file in pieces of some MB, each of whole lines; tabs expanded, byte order mark gone.
struct TextFile {
    std::vector<std::shared_ptr<const std::string>> pieces;
    std::size_t size = 0;  ///< bytes of all pieces
    char line_end = '\n';  ///< a carriage return in a file of an old Macintosh editor
};

/// The lines of a file one after the other.
class LineReader {
  public:
    /// @param file must outlive this
    explicit LineReader(const TextFile& file) : file_(file) {}
    /// The next line without its end, carriage return and trailing blanks; false behind the last.
    bool next(std::string_view& line);

  private:
    const TextFile& file_;
    std::size_t piece_ = 0;
    std::size_t at_ = 0;
};

enum class TextKind {
    deck,  ///< another program's file is an error that names it
    any
};

/// The text of these bytes of a deck; binary content and another program's file are errors.
/// @param blame as for load_text
std::optional<TextFile> text_of(std::string bytes, const std::string& path, const Problem& blame, Problems& problems);

/// Loads a file. A file that is missing, not a regular file, unreadable, too large or binary is an error.
/// @param blame where the message points and which card asked for the file; its value is the path.
std::optional<TextFile> load_text(const std::string& path, const Problem& blame, Problems& problems,
                                  TextKind kind = TextKind::any);

/// Blanks at both ends removed.
std::string_view trimmed(std::string_view text);

/// Letters a..z in upper case, all else unchanged whatever the locale.
std::string upper(std::string_view text);

}  // namespace type21
