/// @file Text inside XML.
#pragma once

#include <string>
#include <string_view>

namespace type21 {

/// Markup escaped; control characters, which XML forbids, become '?'.
std::string escaped_xml(std::string_view text);

}  // namespace type21
