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

struct TextFile {
    std::shared_ptr<const std::string> text;  ///< what the lines point into; tabs expanded, byte order mark gone
    std::vector<std::string_view> lines;      ///< without line end, carriage return and trailing blanks
};

/// The lines of these bytes; binary content is an error.
/// @param blame as for load_text
std::optional<TextFile> text_of(std::string bytes, const std::string& path, const Problem& blame, Problems& problems);

/// Loads a file. A file that is missing, not a regular file, unreadable, too large or binary is an error.
/// @param blame where the message points and which card asked for the file; its value is the path.
std::optional<TextFile> load_text(const std::string& path, const Problem& blame, Problems& problems);

/// Blanks at both ends removed.
std::string_view trimmed(std::string_view text);

/// Letters a..z in upper case, all else unchanged whatever the locale.
std::string upper(std::string_view text);

}  // namespace type21
