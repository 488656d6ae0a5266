/// @file What CMake builds in of reference/formulation (glossary_text.cpp.in).
#pragma once

#include <string_view>

namespace type21 {

/// glossary.md as it is.
std::string_view glossary_markdown();

/// Names of the chapters, each with a space behind it: "01_frames_and_normals.md 02_gap.md ...".
std::string_view chapter_files();

}  // namespace type21
