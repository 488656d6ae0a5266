/// @file The six forms of a [[check]].
#pragma once

#include <filesystem>

#include "verification/criteria/cases/case_file.h"
#include "verification/criteria/cases/toml_keys.h"

namespace type21 {

/// Reads the form, the tolerance, the reason and the unit of a check whose other keys are read already.
/// @param folder  of the case: files that a form names must be there
void read_form(TomlKeys& keys, const std::filesystem::path& folder, CaseCheck& check);

}  // namespace type21
