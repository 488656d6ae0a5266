/// @file The records of an OpenRadioss time-history file: [length][data][length], bytes in either order.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace type21 {

/// The file is not a time-history file, or a damaged one. The message has file, byte offset, what was met and what the
/// format wants there. Exit code 2.
struct T01Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// How the numbers and texts of a file are stored. Two forms are known: /TFILE/4 (the default) writes the most
/// significant byte first, texts one byte a character and reals in single precision; /TFILE/1 writes as the machine
/// does, each four characters of a text in a slot of eight bytes, and reals in double precision.
struct T01Storage {
    bool big_endian = true;
    int text_slot = 4;   ///< bytes that four characters of a text take: 4 or 8
    int real_bytes = 4;  ///< 4 or 8; of the first output time
};

/// Reads one record after the other. Nothing is allocated before the file is known to be long enough for it.
class T01Records {
  public:
    /// @throws T01Error when the file cannot be read or its first record is not that of a time-history file
    explicit T01Records(const std::filesystem::path& path);

    bool at_end() const { return offset_ == size_; }
    /// Of the next record in the file [byte].
    std::uintmax_t offset() const { return offset_; }
    T01Storage& storage() { return storage_; }
    const T01Storage& storage() const { return storage_; }
    const std::string& file() const { return file_; }

    /// @param what    of the record, for messages: "title of a part"
    /// @param length  that it must have [byte]
    /// @throws T01Error on another length, on two lengths that differ, at the end of the file
    const std::vector<unsigned char>& next(const std::string& what, std::uintmax_t length);
    /// A record of one of two lengths.
    const std::vector<unsigned char>& next(const std::string& what, std::uintmax_t length, std::uintmax_t or_length);
    void skip(const std::string& what, std::uintmax_t length) { next(what, length); }

    /// Parts of the last record; `at` is moved behind what was read [byte].
    std::int32_t integer(std::size_t& at) const;
    double real(std::size_t& at) const;
    /// @param characters  without the padding of the slots; blanks at the end are cut;
    ///                    bytes that cannot be shown are escaped
    std::string text(std::size_t& at, int characters) const;

    /// Bytes that a text of so many characters takes.
    std::uintmax_t text_bytes(std::uintmax_t characters) const;
    /// Something is wrong with the last record.
    [[noreturn]] void fail(const std::string& what) const;

  private:
    std::uint32_t read_length(std::uintmax_t offset);
    /// The next bytes of the file; `offset` is only for the message.
    void read(std::uintmax_t offset, std::size_t bytes, unsigned char* into);
    [[noreturn]] void fail_at(std::uintmax_t offset, const std::string& what) const;

    std::string file_;
    std::ifstream stream_;
    std::uintmax_t size_ = 0;
    std::uintmax_t offset_ = 0;
    std::uintmax_t last_ = 0;  ///< offset of the last record
    std::vector<unsigned char> data_;
    T01Storage storage_;
};

}  // namespace type21
