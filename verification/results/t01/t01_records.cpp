#include "verification/results/t01/t01_records.h"

#include <bit>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include "verification/support/shown_text.h"

namespace type21 {
namespace {

constexpr std::uintmax_t title_characters = 80;

std::uint32_t word(const unsigned char* bytes, bool big_endian) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i)
        value = (value << 8) | bytes[big_endian ? i : 3 - i];
    return value;
}

}  // namespace

T01Records::T01Records(const std::filesystem::path& path) : file_(path.string()) {
    std::error_code error;
    size_ = std::filesystem::file_size(path, error);
    stream_.open(path, std::ios::binary);
    if (error || !stream_)
        throw T01Error(fmt::format("{}: cannot be read{}", file_, error ? ": " + error.message() : ""));
    if (size_ < 4) fail_at(0, fmt::format("{} bytes are no time-history file", size_));
    unsigned char first[4];
    read(0, sizeof first, first);
    // The first record is an integer and a title of 80 characters: its length tells order and text at once.
    for (const bool big_endian : {true, false}) {
        for (const int slot : {4, 8}) {
            if (word(first, big_endian) != 4 + title_characters * static_cast<unsigned>(slot) / 4) continue;
            storage_.big_endian = big_endian;
            storage_.text_slot = slot;
            stream_.seekg(0);
            return;
        }
    }
    fail_at(0, fmt::format("the file begins with the bytes {:02x} {:02x} {:02x} {:02x}; a time-history file of "
                           "OpenRadioss (/TFILE/4 or /TFILE/1) begins with the length 84 or 164 of its first record",
                           first[0], first[1], first[2], first[3]));
}

const std::vector<unsigned char>& T01Records::next(const std::string& what, std::uintmax_t length) {
    return next(what, length, length);
}

const std::vector<unsigned char>& T01Records::next(const std::string& what, std::uintmax_t length,
                                                   std::uintmax_t or_length) {
    last_ = offset_;
    if (size_ - offset_ < 4) fail_at(offset_, fmt::format("the file ends where {} should be", what));
    const std::uint32_t before = read_length(offset_);
    if (before != length && before != or_length)
        fail_at(offset_, fmt::format("a record of {} bytes where {} should be, which has {}{}", before, what, length,
                                     length == or_length ? "" : fmt::format(" or {}", or_length)));
    if (size_ - offset_ < std::uintmax_t{8} + before)
        fail_at(offset_,
                fmt::format("the file ends inside {}, a record of {} bytes; it is {} bytes long", what, before, size_));
    data_.resize(before);
    read(offset_ + 4, data_.size(), data_.data());
    const std::uint32_t after = read_length(offset_ + 4 + before);
    if (after != before)
        fail_at(offset_ + 4 + before,
                fmt::format("the length behind {} is {}, the one before it is {}", what, after, before));
    offset_ += std::uintmax_t{8} + before;
    return data_;
}

std::int32_t T01Records::integer(std::size_t& at) const {
    const std::uint32_t value = word(data_.data() + at, storage_.big_endian);
    at += 4;
    return static_cast<std::int32_t>(value);
}

double T01Records::real(std::size_t& at) const {
    const std::uint64_t first = word(data_.data() + at, storage_.big_endian);
    at += 4;
    if (storage_.real_bytes == 4) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(first)));
    const std::uint64_t second = word(data_.data() + at, storage_.big_endian);
    at += 4;
    return std::bit_cast<double>(storage_.big_endian ? (first << 32) | second : (second << 32) | first);
}

std::string T01Records::text(std::size_t& at, int characters) const {
    std::string out;
    for (int i = 0; i < characters; i += 4) {
        out.append(reinterpret_cast<const char*>(data_.data() + at), 4);
        at += static_cast<std::size_t>(storage_.text_slot);
    }
    out.erase(out.find_last_not_of(std::string_view(" \0", 2)) + 1);
    return shown(out, out.size());
}

std::uintmax_t T01Records::text_bytes(std::uintmax_t characters) const {
    return characters / 4 * static_cast<std::uintmax_t>(storage_.text_slot);
}

void T01Records::fail(const std::string& what) const {
    fail_at(last_, what);
}

std::uint32_t T01Records::read_length(std::uintmax_t offset) {
    unsigned char bytes[4];
    read(offset, sizeof bytes, bytes);
    return word(bytes, storage_.big_endian);
}

void T01Records::read(std::uintmax_t offset, std::size_t bytes, unsigned char* into) {
    stream_.read(reinterpret_cast<char*>(into), static_cast<std::streamsize>(bytes));
    if (!stream_) fail_at(offset, fmt::format("{} bytes cannot be read", bytes));
}

void T01Records::fail_at(std::uintmax_t offset, const std::string& what) const {
    throw T01Error(fmt::format("{}: byte {}: {}. Take the file as OpenRadioss left it, from a run that ended", file_,
                               offset, what));
}

}  // namespace type21
