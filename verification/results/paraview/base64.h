/// @file Bytes as text, for the arrays of a .vtu.
#pragma once

#include <cstddef>
#include <string>

namespace type21 {

/// RFC 4648, with padding.
std::string base64(const void* bytes, std::size_t size);

}  // namespace type21
