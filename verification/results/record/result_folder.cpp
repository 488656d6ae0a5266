#include "verification/results/record/result_folder.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "verification/results/record/result_files.h"
#include "verification/support/io_error.h"

namespace type21 {
namespace fs = std::filesystem;
namespace {

bool is_there(const fs::path& path) {
    std::error_code error;
    return fs::exists(fs::symlink_status(path, error));
}

/// Without a slash at the end, and with a name.
fs::path named(const fs::path& given) {
    fs::path path = given;
    while (!path.has_filename() && path.has_relative_path())
        path = path.parent_path();
    if (path.filename() == "." || path.filename() == "..") {
        std::error_code error;
        const fs::path real = fs::canonical(path, error);
        if (!error) path = real;
    }
    return path;
}

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return fs::equivalent(a, b, error) && !error;
}

bool is_mount_point(const fs::path& folder) {
    struct stat here {
    }, above{};
    if (lstat(folder.c_str(), &here) != 0 || lstat((folder / "..").c_str(), &above) != 0) return false;
    return here.st_dev != above.st_dev || here.st_ino == above.st_ino;
}

/// @throws FolderError unless a result may take this place
void require_place(const fs::path& target) {
    const auto refuse = [&](const std::string& why) {
        throw FolderError(fmt::format("{}: {}. Choose another --out", target.string(), why));
    };
    std::error_code error;
    const fs::file_status status = fs::symlink_status(target, error);
    if (status.type() == fs::file_type::not_found) return;
    if (error) throw FolderError(fmt::format("{}: cannot be read: {}", target.string(), error.message()));
    if (fs::is_symlink(status)) refuse("is a link; a result would take its place. Name the folder itself");
    if (!fs::is_directory(status)) refuse("is a file, not a folder");
    if (is_mount_point(target)) refuse("is a mount point, which nothing can take the place of. Name a folder below it");
    if (same_file(target, fs::current_path(error)) && !error)
        refuse("is the current folder, whose place a result would take. Name a folder below it");
    std::string foreign;
    try {
        foreign = foreign_content(target);
    } catch (const IoError& unreadable) {
        throw FolderError(unreadable.what());
    }
    if (!foreign.empty())
        throw FolderError(
            fmt::format("{}. A result takes the place of the whole folder: move this away, or choose "
                        "another --out",
                        foreign));
}

/// @return -1 when it cannot be opened
int open_folder(const fs::path& folder) {
    return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/// Waits until the disk has these files and the names of them.
void sync(const fs::path& folder) {
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const int file = ::open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
        if (file < 0) continue;
        const int failed = fsync(file) != 0 ? errno : 0;
        ::close(file);
        if (failed == EIO || failed == ENOSPC) throw IoError(entry->path(), "cannot be written", failed);
    }
}

void sync_folder(const fs::path& folder) {
    const int file = open_folder(folder.empty() ? "." : folder);
    if (file < 0) return;
    fsync(file);
    ::close(file);
}

}  // namespace

ResultFolder::ResultFolder(const fs::path& target, const std::string& run_id) : target_(named(target)) {
    require_place(target_);
    std::error_code error;
    if (target_.has_parent_path()) {
        fs::create_directories(target_.parent_path(), error);
        if (error)
            throw FolderError(
                fmt::format("{}: cannot be created: {}", target_.parent_path().string(), error.message()));
    }
    look_around();
    path_ = target_;
    path_ += fmt::format(".{}.partial", run_id.substr(0, 8));
    if (::mkdir(path_.c_str(), 0777) != 0)
        throw FolderError(
            fmt::format("{}: cannot be created: {}", path_.string(), std::generic_category().message(errno)));
    lock_ = open_folder(path_);
    if (lock_ >= 0) flock(lock_, LOCK_EX | LOCK_NB);
}

ResultFolder::~ResultFolder() {
    if (!kept_) remove_result(path_);
    if (lock_ >= 0) ::close(lock_);
}

void ResultFolder::look_around() {
    const fs::path parent = target_.has_parent_path() ? target_.parent_path() : ".";
    const std::string begin = target_.filename().string() + ".", end = ".partial";
    std::error_code error;
    std::vector<fs::path> found;
    for (fs::directory_iterator entry(parent, error), last; !error && entry != last; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.size() == begin.size() + 8 + end.size() && name.starts_with(begin) && name.ends_with(end))
            found.push_back(target_.has_parent_path() ? entry->path() : entry->path().filename());
    }
    std::sort(found.begin(), found.end());
    for (const fs::path& folder : found) {
        if (!read_run_mark(folder)) continue;
        const int lock = open_folder(folder);
        if (lock < 0) continue;
        const bool lives = flock(lock, LOCK_EX | LOCK_NB) != 0;
        const std::vector<fs::path> checkpoints = checkpoints_in(folder);
        if (lives) {
            notes_.push_back(
                fmt::format("{}: another run is writing into {}; the result of the one that ends last "
                            "stays",
                            folder.string(), target_.string()));
        } else if (!checkpoints.empty()) {
            notes_.push_back(fmt::format("{}: left by a run that was killed; go on with --restart {}, or remove it",
                                         folder.string(), checkpoints.back().string()));
        } else if (remove_result(folder)) {
            notes_.push_back(fmt::format("{}: removed; a run that was killed had left it", folder.string()));
        }
        ::close(lock);
    }
}

void ResultFolder::publish(bool durable) {
    kept_ = true;  // whatever happens now, the result is whole
    if (durable) sync(path_);
    take_place();
    if (durable) sync_folder(target_.parent_path());
}

void ResultFolder::take_place() {
    const auto fail = [&](const std::string& why) {
        throw IoError(fmt::format("{}: {}. The result is whole in {}", target_.string(), why, path_.string()));
    };
    const auto reason = [](int number) { return std::generic_category().message(number); };
    while (true) {
        if (!is_there(path_)) throw IoError(path_, "has been removed while the run wrote into it", 0);
        if (!is_there(target_)) {
            if (renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0) return;
            if (errno == EEXIST) continue;  // another run was faster
            // A file system without this kind of move: an empty folder may be replaced, nothing else.
            if (errno != EINVAL && errno != ENOSYS) fail("cannot be written: " + reason(errno));
            if (::rename(path_.c_str(), target_.c_str()) == 0) return;
            if (errno != EEXIST && errno != ENOTEMPTY) fail("cannot be written: " + reason(errno));
            continue;
        }
        try {
            require_place(target_);
        } catch (const FolderError& refused) {
            fail(refused.what());
        }
        if (renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
            remove_result(path_);  // now the earlier result
            return;
        }
        if (errno == ENOENT) continue;
        if (errno != EINVAL && errno != ENOSYS) fail("cannot be replaced: " + reason(errno));
        const fs::path aside = fs::path(path_) += ".earlier";
        if (::rename(target_.c_str(), aside.c_str()) != 0) fail("cannot be replaced: " + reason(errno));
        if (::rename(path_.c_str(), target_.c_str()) != 0) {
            const int number = errno;
            if (::rename(aside.c_str(), target_.c_str()) != 0)
                fail(
                    fmt::format("cannot be replaced: {}. The earlier result is in {}", reason(number), aside.string()));
            fail("cannot be replaced: " + reason(number));
        }
        remove_result(aside);
        return;
    }
}

}  // namespace type21
