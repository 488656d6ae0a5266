#include "reference/deck/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace type21 {

namespace {

namespace fs = std::filesystem;

/// True where a text has no business to be: a NUL, or more control characters than a slip of an editor explains.
bool is_binary(std::string_view text) {
    std::size_t controls = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte == 0) return true;
        const bool harmless = byte >= 32 || (byte >= '\t' && byte <= '\r') || byte == 0x1A;
        controls += harmless ? 0 : 1;
    }
    return controls > 8 || controls * 50 > text.size();
}

std::string without_tabs(std::string_view text) {
    std::string out;
    out.reserve(text.size() + text.size() / 4);
    std::size_t column = 0;
    for (const char c : text) {
        if (c == '\t') {
            const std::size_t blanks = tab_stop - column % tab_stop;
            out.append(blanks, ' ');
            column += blanks;
        } else {
            out.push_back(c);
            column = (c == '\n' || c == '\r') ? 0 : column + 1;
        }
    }
    return out;
}

std::vector<std::string_view> split(std::string_view text) {
    // A file with carriage returns alone comes from an old Macintosh editor.
    const char end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
    std::vector<std::string_view> lines;
    lines.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), end)) + 1);
    while (!text.empty()) {
        const std::size_t at = std::min(text.find(end), text.size());
        const std::string_view line = text.substr(0, at);
        const std::size_t last = line.find_last_not_of(" \r\f\v\x1A");
        lines.push_back(line.substr(0, last == std::string_view::npos ? 0 : last + 1));
        text.remove_prefix(std::min(at + 1, text.size()));
    }
    return lines;
}

/// The bytes of the file, or what is wrong with it in `fault`.
std::string read_bytes(const std::string& path, std::string& fault) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (!fs::exists(status)) {
        fault = "there is no such file";
    } else if (fs::is_directory(status)) {
        fault = "this is a folder, not a file";
    } else if (!fs::is_regular_file(status)) {
        fault = "this is not an ordinary file";
    } else if (fs::file_size(path, code) > max_bytes) {
        fault = "the file is larger than 2 GB";
    }
    if (!fault.empty()) return {};
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) {
        fault = std::string("the file cannot be opened: ") + std::strerror(errno);
        return {};
    }
    std::string bytes(fs::file_size(path, code), '\0');
    bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
    if (std::ferror(file) != 0) fault = "the file cannot be read";
    std::fclose(file);
    return bytes;
}

std::nullopt_t refuse(const std::string& path, Problem problem, Problems& problems, const std::string& rule,
                      const std::string& remedy) {
    problem.value = path;
    problem.rule = rule;
    problem.remedy = remedy;
    problems.add(std::move(problem));
    return std::nullopt;
}

}  // namespace

std::optional<TextFile> text_of(std::string bytes, const std::string& path, const Problem& blame, Problems& problems) {
    if (is_binary(bytes)) {
        return refuse(path, blame, problems, "the file is binary, not text",
                      "Save the deck as plain text (ASCII or UTF-8)");
    }
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
    if (bytes.find('\t') != std::string::npos) bytes = without_tabs(bytes);
    TextFile file;
    file.text = std::make_shared<const std::string>(std::move(bytes));
    file.lines = split(*file.text);
    return file;
}

std::optional<TextFile> load_text(const std::string& path, const Problem& blame, Problems& problems) {
    std::string fault;
    std::string bytes = read_bytes(path, fault);
    if (!fault.empty()) return refuse(path, blame, problems, fault, "Give the path of a readable text file");
    return text_of(std::move(bytes), path, blame, problems);
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return out;
}

}  // namespace type21
