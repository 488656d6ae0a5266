/// @file A JSON text from outside: read whole or refused with the place of what is wrong.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace type21 {

/// Lists and objects inside each other; the files of this program have 6 levels.
inline constexpr int deepest_json = 64;
/// A larger file is refused before it fills the memory, of which it takes about ten times as much [byte].
inline constexpr std::size_t largest_json = std::size_t{1} << 30;

/// RFC 8259, with a byte-order mark of UTF-8 allowed. Refused: another text, UTF-16, a number too large for a double,
/// a key that is there twice in one object, more than deepest_json levels, more than largest_json bytes.
/// @param name      of the text, for messages: "FILE:3:17: /blocks/0/nodes/0/0: ..."
/// @param problems  what is wrong
/// @return nothing when a problem was added
std::optional<nlohmann::json> parse_json(std::string_view text, const std::string& name,
                                         std::vector<std::string>& problems);
/// The same of a file.
std::optional<nlohmann::json> read_json(const std::filesystem::path& file, std::vector<std::string>& problems);

}  // namespace type21
