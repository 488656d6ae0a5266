#include <fstream>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"

namespace type21::cli {

void write_report(const std::filesystem::path& path, const std::string& text) {
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << text;
    file.flush();
    if (!file) throw UsageError(fmt::format("{}: cannot be written", path.string()));
}

void write_report(const std::filesystem::path& path, const nlohmann::ordered_json& json) {
    // A title of a deck may be in any encoding: bytes that are not UTF-8 are replaced.
    write_report(path, json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace type21::cli
