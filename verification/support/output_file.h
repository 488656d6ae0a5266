/// @file Files that are written in one go or grow: every byte reaches the system or an IoError says why not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "verification/support/checksum.h"

namespace type21 {

/// A file that grows. What it is given is collected and handed to the system in pieces that end where a call of write
/// ended: whoever reads the file meets whole rows.
class OutputFile {
  public:
    enum class Start {
        create,  ///< a file or link of this name is an error
        append   ///< goes on at the end of a file
    };

    /// @throws IoError
    OutputFile(const std::filesystem::path& path, Start start);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    /// @throws IoError
    void write(std::string_view bytes);
    /// Everything to the system. What it does not take is cut off again.
    /// @throws IoError, also when the file has been deleted meanwhile
    void flush();
    /// Flushes and closes. @throws IoError
    void close();

    const std::filesystem::path& path() const { return path_; }
    std::uint64_t bytes() const { return bytes_; }  ///< since the beginning of the file
    std::string checksum() const { return checksum_.text(); }

  private:
    std::filesystem::path path_;
    int file_ = -1;
    std::string waiting_;
    std::uint64_t bytes_ = 0;
    std::uint64_t flushed_ = 0;
    Checksum checksum_;
};

/// Writes a file under a new name beside it and moves it into place: a reader meets the old one or the new one, whole.
/// A link of that name is replaced, never followed.
/// @throws IoError; the old file is then as it was
void replace_file(const std::filesystem::path& path, std::string_view bytes);

/// `digits` random hexadecimal digits.
std::string random_digits(int digits);

}  // namespace type21
