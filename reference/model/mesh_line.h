/// @file The lines of /NODE, /SHELL and /SH3N that hold plain numbers, read at full speed.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "reference/contract/mesh.h"

namespace type21 {

/// A deck has one of these lines for every node and shell and little else. What is as plain as almost all of them are
/// is read here; any other line (a word that is no number, one that runs across a border, text behind the last field)
/// is left to CardReader, which knows what to say about it.
struct PlainNode {
    Id id = 0;
    std::array<double, 3> position{};  ///< as written
};
std::optional<PlainNode> plain_node(std::string_view line);

struct PlainShell {
    Id id = 0;
    std::array<Id, 4> node{};  ///< the fourth repeats the third where it is 0 or not there
    double thickness = 0;      ///< as written
};
/// @param corners 4 for /SHELL, 3 for /SH3N
std::optional<PlainShell> plain_shell(std::string_view line, int corners);

}  // namespace type21
