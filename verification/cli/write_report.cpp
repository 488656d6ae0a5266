#include <cerrno>
#include <cstdio>
#include <fstream>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/support/io_error.h"
#include "verification/support/output_file.h"

namespace type21::cli {
namespace {

namespace fs = std::filesystem;

bool is_device(const fs::path& path) {
    std::error_code error;
    const fs::file_type type = fs::status(path, error).type();
    const std::string name = path.string();
    return type == fs::file_type::character || type == fs::file_type::fifo || name.starts_with("/dev/") ||
           name.starts_with("/proc/self/fd/");
}

void write_device(const fs::path& path, const std::string& text) {
    std::fflush(stdout);
    errno = 0;
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw IoError(path, "cannot be written", errno);
}

/// What a file of this kind begins with.
char first_character(const std::string& text) {
    const size_t first = text.find_first_not_of(" \t\r\n");
    return first == std::string::npos ? '\0' : text[first];
}

/// @throws UsageError when something is there that is not a report of this kind
void require_replaceable(const fs::path& path, const std::string& text) {
    std::error_code error;
    const fs::file_status status = fs::symlink_status(path, error);
    if (status.type() == fs::file_type::not_found) return;
    const auto refuse = [&](const char* why) { throw UsageError(fmt::format("{}: {}", path.string(), why)); };
    if (fs::is_symlink(status)) refuse("is a link, which is not followed. Name the file itself");
    if (fs::is_directory(status)) refuse("is a folder. Give the name of a file");
    if (!fs::is_regular_file(status)) refuse("is not a file");
    std::ifstream file(path, std::ios::binary);
    std::string begin(256, '\0');
    file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<size_t>(file.gcount()));
    if (const char there = first_character(begin); there != '\0' && there != first_character(text))
        refuse("is there and is not such a file: type21 has not written it. Choose another name, or remove it");
}

}  // namespace

void write_report(const fs::path& path, const std::string& text) {
    if (is_device(path)) return write_device(path, text);
    require_replaceable(path, text);
    std::error_code error;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    if (error) throw UsageError(fmt::format("{}: cannot be created: {}", path.parent_path().string(), error.message()));
    replace_file(path, text);
}

void write_report(const fs::path& path, const nlohmann::ordered_json& json) {
    // A title of a deck may be in any encoding: bytes that are not UTF-8 are replaced.
    write_report(path, json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace type21::cli
