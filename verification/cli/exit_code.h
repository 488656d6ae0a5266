/// @file What the exit code of type21 says.
#pragma once

#include <filesystem>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace type21::cli {

enum ExitCode : int {
    exit_ok = 0,
    exit_usage = 1,     ///< wrong command line, or a folder or file of ours that cannot be used
    exit_deck = 2,      ///< the deck (or a case.toml) has errors
    exit_mismatch = 3,  ///< histories differ, or a check failed
    exit_stopped = 4    ///< the run stopped or diverged, or an internal error
};

/// The command cannot be done as given; the message says why. Exit code 1.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Writes a file that --json or --junit names; missing folders are made.
/// @throws UsageError when it cannot be written
void write_report(const std::filesystem::path& path, const std::string& text);
void write_report(const std::filesystem::path& path, const nlohmann::ordered_json& json);

}  // namespace type21::cli
