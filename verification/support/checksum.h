/// @file A checksum of bytes, to find out whether a file is whole and unchanged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace type21 {

/// CRC-64/XZ. It finds every accidental change that matters here; it is no protection against a forger.
class Checksum {
  public:
    void add(std::string_view bytes);
    std::uint64_t value() const;
    /// 16 hexadecimal digits.
    std::string text() const;

  private:
    std::uint64_t remainder_ = ~std::uint64_t{0};
};

/// Adds the first `bytes` bytes of a file, all of it by default.
/// @return how many there were
/// @throws IoError when it cannot be read
std::uint64_t add_file(Checksum& checksum, const std::filesystem::path& path, std::uint64_t bytes = ~std::uint64_t{0});

}  // namespace type21
