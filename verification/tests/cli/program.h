/// @file Runs the built program as a user does.
#pragma once

#include <cstdlib>
#include <string>
#include <sys/wait.h>

#include "verification/tests/temp_folder.h"

namespace type21::test {

/// For the shell.
inline std::string in_quotes(const std::filesystem::path& path) {
    return "'" + path.string() + "'";
}

struct Outcome {
    int code = -1;  ///< exit code; -1: killed by a signal
    std::string out, err;
};

/// @param arguments  as typed in a shell
inline Outcome type21(const std::string& arguments) {
    TempFolder folder;
    const std::string command = std::string("'") + TYPE21_BINARY + "' " + arguments + " > '" +
                                (folder / "out").string() + "' 2> '" + (folder / "err").string() + "' < /dev/null";
    const int status = std::system(command.c_str());
    Outcome outcome;
    if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
    outcome.out = read_text(folder / "out");
    outcome.err = read_text(folder / "err");
    return outcome;
}

inline std::filesystem::path cases() {
    return std::filesystem::path(TYPE21_SOURCE_DIR) / "cases";
}

/// A deck with its engine deck, copied so that a test may spoil it.
struct DeckCopy {
    TempFolder folder;
    std::filesystem::path starter, engine;

    explicit DeckCopy(const std::string& name)
        : starter(folder / (name + "_0000.rad")), engine(folder / (name + "_0001.rad")) {
        std::filesystem::copy_file(cases() / name / starter.filename(), starter);
        std::filesystem::copy_file(cases() / name / engine.filename(), engine);
    }
    void replace(const std::filesystem::path& file, const std::string& from, const std::string& to) const {
        std::string text = read_text(file);
        const size_t at = text.find(from);
        if (at == std::string::npos) throw std::runtime_error("the deck has no '" + from + "'");
        write_text(file, text.replace(at, from.size(), to));
    }
    std::string out() const { return (folder / "out").string(); }
};

inline size_t count_lines(const std::string& text) {
    size_t lines = 0;
    for (const char c : text)
        lines += c == '\n' ? 1 : 0;
    return lines;
}

}  // namespace type21::test
