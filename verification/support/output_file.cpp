#include "verification/support/output_file.h"

#include <cerrno>
#include <fcntl.h>
#include <random>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include "verification/support/io_error.h"

namespace type21 {
namespace {

constexpr size_t piece = 1 << 18;  ///< handed to the system at a time [byte]

/// @return 0 or errno
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes.remove_prefix(static_cast<size_t>(count));
    }
    return 0;
}

}  // namespace

IoError::IoError(const std::filesystem::path& path, const std::string& what, int number)
    : std::runtime_error(
          number == 0 ? fmt::format("{}: {}", path.string(), what)
                      : fmt::format("{}: {}: {}", path.string(), what, std::generic_category().message(number))) {}

std::string random_digits(int digits) {
    std::random_device random;
    std::string text;
    while (text.size() < static_cast<size_t>(digits))
        text += fmt::format("{:08x}", random());
    return text.substr(0, static_cast<size_t>(digits));
}

OutputFile::OutputFile(const std::filesystem::path& path, Start start) : path_(path) {
    if (start == Start::append) flushed_ = bytes_ = add_file(checksum_, path);
    const int how = start == Start::append ? O_APPEND : O_CREAT | O_EXCL;
    file_ = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC | how, 0666);
    if (file_ < 0) throw IoError(path, "cannot be written", errno);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)),
      waiting_(std::move(other.waiting_)),
      bytes_(other.bytes_),
      flushed_(other.flushed_),
      checksum_(other.checksum_) {}

OutputFile::~OutputFile() {
    if (file_ < 0) return;
    write_all(file_, waiting_);
    ::close(file_);
}

void OutputFile::write(std::string_view bytes) {
    if (!waiting_.empty() && waiting_.size() + bytes.size() > piece) flush();
    waiting_ += bytes;
    bytes_ += bytes.size();
    checksum_.add(bytes);
}

void OutputFile::flush() {
    if (file_ < 0) return;
    struct stat now {};
    if (fstat(file_, &now) == 0 && now.st_nlink == 0) {
        waiting_.clear();
        throw IoError(path_, "has been deleted while it was written", 0);
    }
    const int error = write_all(file_, waiting_);
    waiting_.clear();
    if (error != 0) {
        if (ftruncate(file_, static_cast<off_t>(flushed_)) != 0) errno = 0;  // there is nothing more to do
        throw IoError(path_, "cannot be written", error);
    }
    flushed_ = bytes_;
}

void OutputFile::close() {
    flush();
    if (file_ >= 0 && ::close(std::exchange(file_, -1)) != 0) throw IoError(path_, "cannot be written", errno);
}

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
    const std::filesystem::path fresh = fmt::format("{}.{}.new", path.string(), random_digits(8));
    const auto fail = [&](int number) {
        ::unlink(fresh.c_str());
        throw IoError(path, "cannot be written", number);
    };
    const int file = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (file < 0) throw IoError(path, "cannot be written", errno);
    const int error = write_all(file, bytes);
    const int closing = ::close(file) != 0 ? errno : 0;
    if (error != 0 || closing != 0) fail(error != 0 ? error : closing);
    if (::rename(fresh.c_str(), path.c_str()) != 0) fail(errno);
}

}  // namespace type21
