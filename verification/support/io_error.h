/// @file The system does not read or write what it is asked to.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace type21 {

/// A full disk, a folder that has gone, a closed pipe, a right that is missing. The message has path and reason. Exit
/// code 5.
struct IoError : std::runtime_error {
    /// @param what    "cannot be written"
    /// @param number  errno; 0 where there is none
    IoError(const std::filesystem::path& path, const std::string& what, int number);
    explicit IoError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace type21
