#include "reference/deck/include_line.h"

#include <algorithm>
#include <filesystem>

#include "reference/deck/text_file.h"

namespace type21 {

namespace fs = std::filesystem;

std::optional<std::vector<std::string>> included_names(std::string_view text) {
    constexpr std::string_view word = "#INCLUDE";
    if (upper(text.substr(0, word.size())) != word) return std::nullopt;
    text.remove_prefix(word.size());
    if (!text.empty() && text.front() != ' ' && text.front() != '"' && text.front() != '\'') return std::nullopt;
    const std::string_view name = trimmed(text);
    if (name.empty()) return std::vector<std::string>{""};
    if (name.front() == '"' || name.front() == '\'') {
        if (const std::size_t end = name.find(name.front(), 1); end != std::string_view::npos)
            return std::vector<std::string>{std::string(trimmed(name.substr(1, end - 1)))};
    }
    std::vector<std::string> names{std::string(name)};
    for (const std::string_view comment : {" #", " $"}) {
        if (const std::size_t at = name.find(comment); at != std::string_view::npos)
            names.emplace_back(trimmed(name.substr(0, at)));
    }
    return names;
}

bool is_end_of_data(std::string_view text) {
    constexpr std::string_view word = "#ENDDATA";
    return upper(text.substr(0, word.size())) == word && (text.size() == word.size() || text[word.size()] == ' ');
}

std::vector<std::string> include_paths(const std::string& name, const std::string& including, const std::string& main) {
    std::string slashes = name;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    std::vector<std::string> paths;
    for (const fs::path& folder : {fs::path(including).parent_path(), fs::path(main).parent_path(), fs::path()}) {
        for (const std::string& spelling : {name, slashes}) {
            const std::string path = (folder / spelling).lexically_normal().string();
            if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
        }
    }
    return paths;
}

}  // namespace type21
