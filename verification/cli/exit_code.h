/// @file The exit codes of type21.
#pragma once

#include <filesystem>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace type21::cli {

enum ExitCode : int {
    exit_ok = 0,
    exit_usage = 1,       ///< wrong command line, or a folder or output file that cannot be used
    exit_deck = 2,        ///< the deck (or a case.toml) has errors
    exit_mismatch = 3,    ///< histories or decisions differ, or a criterion failed
    exit_stopped = 4,     ///< the run stopped or diverged, or an internal error
    exit_io = 5,          ///< a disk, a folder or a pipe did not take the output, or did not give the input
    exit_interrupted = 6  ///< the run was told to stop by a signal
};

/// The command line cannot be carried out; the message says why. Exit code 1.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Writes a file that --json or --junit names, under a new name that takes its place; missing folders are created. A
/// device or a pipe, such as /dev/stdout, is written to.
/// @throws UsageError when the name is that of a folder, of a link, or of a file that is no such report; IoError
void write_report(const std::filesystem::path& path, const std::string& text);
void write_report(const std::filesystem::path& path, const nlohmann::ordered_json& json);

}  // namespace type21::cli
