#include "verification/support/checksum.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <cerrno>
#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "verification/support/io_error.h"

namespace type21 {
namespace {

using Crc = boost::crc_optimal<64, 0x42F0E1EBA9EA3693ULL, ~0ULL, ~0ULL, true, true>;

}  // namespace

void Checksum::add(std::string_view bytes) {
    Crc crc(remainder_);
    crc.process_bytes(bytes.data(), bytes.size());
    remainder_ = crc.get_interim_remainder();
}

std::uint64_t Checksum::value() const {
    return Crc(remainder_).checksum();
}

std::string Checksum::text() const {
    return fmt::format("{:016x}", value());
}

std::uint64_t add_file(Checksum& checksum, const std::filesystem::path& path, std::uint64_t bytes) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) throw IoError(path, "cannot be read", errno);
    std::vector<char> part(1 << 16);
    std::uint64_t done = 0;
    while (file && done < bytes) {
        file.read(part.data(), static_cast<std::streamsize>(std::min<std::uint64_t>(part.size(), bytes - done)));
        const auto count = static_cast<size_t>(file.gcount());
        checksum.add({part.data(), count});
        done += count;
    }
    if (file.bad()) throw IoError(path, "cannot be read", errno);
    return done;
}

}  // namespace type21
