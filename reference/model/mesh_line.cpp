#include "reference/model/mesh_line.h"

#include <charconv>
#include <cmath>

namespace type21 {

namespace {

/// The word in columns first..last; none when it touches the next field.
std::optional<std::string_view> plain_word(std::string_view line, std::size_t first, std::size_t last) {
    if (line.size() < first) return std::string_view{};
    if (line.size() > last && line[last - 1] != ' ' && line[last] != ' ') return std::nullopt;
    std::string_view word = line.substr(first - 1, last - first + 1);
    const std::size_t begin = word.find_first_not_of(' ');
    if (begin == std::string_view::npos) return std::string_view{};
    word.remove_prefix(begin);
    while (word.back() == ' ')
        word.remove_suffix(1);
    return word;
}

template <class Number>
bool plain_number(std::string_view line, std::size_t first, std::size_t last, Number& value) {
    auto word = plain_word(line, first, last);
    if (!word) return false;
    value = 0;
    if (word->size() > 1 && (*word)[0] == '+' && (*word)[1] != '-') word->remove_prefix(1);
    if (word->empty()) return true;
    const auto [end, code] = std::from_chars(word->data(), word->data() + word->size(), value);
    return code == std::errc() && end == word->data() + word->size();
}

bool plain_real(std::string_view line, std::size_t first, std::size_t last, double& value) {
    return plain_number(line, first, last, value) && std::isfinite(value);
}

}  // namespace

std::optional<PlainNode> plain_node(std::string_view line) {
    PlainNode node;
    const bool plain = line.size() <= 70 && plain_number(line, 1, 10, node.id) && node.id > 0 &&
                       plain_real(line, 11, 30, node.position[0]) && plain_real(line, 31, 50, node.position[1]) &&
                       plain_real(line, 51, 70, node.position[2]);
    return plain ? std::optional(node) : std::nullopt;
}

std::optional<PlainShell> plain_shell(std::string_view line, int corners) {
    PlainShell shell;
    if (line.size() > 100 || !plain_number(line, 1, 10, shell.id) || shell.id <= 0) return std::nullopt;
    std::size_t first = 11;
    for (int corner = 0; corner < corners; ++corner, first += 10) {
        if (!plain_number(line, first, first + 9, shell.node[static_cast<std::size_t>(corner)])) return std::nullopt;
    }
    if (shell.node[3] == 0) shell.node[3] = shell.node[2];
    if (line.size() < first) return shell;
    double angle = 0;  // of the material's axes: nothing here has any
    if (line.substr(first - 1, 61 - first).find_first_not_of(' ') != std::string_view::npos ||
        !plain_real(line, 61, 80, angle) || !plain_real(line, 81, 100, shell.thickness))
        return std::nullopt;
    return shell;
}

}  // namespace type21
