/// @file The six forms of a [[criterion]].
#pragma once

#include <filesystem>

#include "verification/criteria/cases/case_file.h"
#include "verification/criteria/cases/toml_keys.h"

namespace type21 {

/// Reads the form, the tolerance, the reason and the unit of a criterion whose other keys have been read.
/// @param folder  folder of the case, which must hold the files that a form names
void read_form(TomlKeys& keys, const std::filesystem::path& folder, Criterion& criterion);

}  // namespace type21
