/// @file A digest of the content of files, to see whether something changed.
#pragma once

#include <filesystem>
#include <string>

namespace type21 {

/// False in a program that was built without xxHash; what the others give is then of no use.
bool has_digest();

/// 128 bits of xxHash in hex, over the bytes of a file, or over the names and bytes of all files below a folder.
/// @throws std::runtime_error if a file cannot be read
std::string digest_of(const std::filesystem::path& file_or_folder);

/// The same over the text itself.
std::string digest_of_text(const std::string& text);

}  // namespace type21
