/// @file A folder for one test, gone after it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

namespace type21::test {

inline void write_text(const std::filesystem::path& path, std::string_view text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

class TempFolder {
  public:
    TempFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "type21_XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = pattern;
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    std::string path(const std::string& name) const { return (path_ / name).string(); }

    /// Writes these bytes and returns the path.
    std::string write(const std::string& name, std::string_view text) const {
        write_text(path_ / name, text);
        return path(name);
    }

  private:
    std::filesystem::path path_;
};

inline std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A file of a result but for the line that says which run wrote it.
inline std::string without_mark(const std::filesystem::path& path) {
    std::string text = read_text(path);
    for (const char* mark : {"# type21 ", "<!-- type21 "}) {
        const size_t at = text.rfind(mark);
        if (at != std::string::npos) text.erase(at, text.find('\n', at) + 1 - at);
    }
    return text;
}

}  // namespace type21::test
