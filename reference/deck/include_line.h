/// @file The line "#include FILE".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace type21 {

/// What an "#include" line may name, most likely first: the text in quotes, or all of the line, or what stands before a
/// comment at its end. An empty name is "". None when the line is another comment.
/// @param text a line that begins with '#'
std::optional<std::vector<std::string>> included_names(std::string_view text);

/// True for "#enddata": what follows in this file is not read.
bool is_end_of_data(std::string_view text);

/// The paths where an included file is looked for, in this order: beside the including file, beside the main deck, in
/// the working directory; in each as written and, for a deck from Windows, with '/' for every backslash. The public
/// manual speaks of the working directory, which is the main deck's folder where a run is started in it; the including
/// file comes first so that a set of files that includes one another can be put anywhere.
/// @param including, main paths of these two files
std::vector<std::string> include_paths(const std::string& name, const std::string& including, const std::string& main);

}  // namespace type21
