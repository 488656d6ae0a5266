/// @file A folder of its own for the files that a test writes; gone when the test is.
#pragma once

#include <filesystem>
#include <fstream>
#include <stdlib.h>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "reference/deck/deck.h"

namespace type21::test {

class TempFolder {
  public:
    TempFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "type21_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~TempFolder() {
        std::error_code code;
        std::filesystem::remove_all(path_, code);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    std::string path(const std::string& name) const { return (path_ / name).string(); }

    /// Writes these bytes and returns the path.
    std::string write(const std::string& name, std::string_view text) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file.string();
    }

  private:
    std::filesystem::path path_;
};

/// All messages, one a line, for the output of a failing test.
inline std::string all_of(const Problems& problems) {
    std::string text;
    for (const Problem& problem : problems.list())
        text += to_text(problem) + "\n";
    return text;
}

/// The first problem whose rule contains these words; nullptr if none does.
inline const Problem* find_rule(const Problems& problems, std::string_view words) {
    for (const Problem& problem : problems.list()) {
        if (problem.rule.find(words) != std::string::npos) return &problem;
    }
    return nullptr;
}

/// The text with its one piece `from` replaced; a test that replaces nothing tests nothing.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "the text has no '" << from << "'";
    if (at != std::string::npos) text.replace(at, from.size(), to);
    return text;
}

}  // namespace type21::test
