/// @file What a file is when it is no Radioss deck.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace type21 {

/// "a LS-DYNA deck", "a PDF document", ... by the first bytes of a file, or empty. A file that could be a Radioss deck
/// or a piece of one is never named.
/// @param bytes the beginning of the file, or all of it
/// @param size  of the file
/// @param path  only its ending counts, and only for bytes that are no text
std::string foreign_format(std::string_view bytes, std::string_view path, std::uintmax_t size);

}  // namespace type21
