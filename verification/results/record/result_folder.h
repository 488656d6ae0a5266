/// @file The folder that a run writes into, and how it takes the place of an earlier result.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace type21 {

/// The folder cannot be used; the message says why and what to do. Exit code 1.
struct FolderError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A run writes into a folder of its own beside the target, "<target>.<8 digits>.partial", and takes the target's place
/// in one step at its end. Until then the target is as it was; two runs into one target never mix, the one that ends
/// last stays.
///
/// A target that is a file, a link or a mount point, or that holds anything that type21 has not written, is refused and
/// left alone.
class ResultFolder {
  public:
    /// Also removes what runs into the same target have left that were killed; one with a checkpoint stays. See
    /// notes().
    /// @param run_id  from new_run_id(); the folder is named after it
    /// @throws FolderError before anything is computed
    ResultFolder(const std::filesystem::path& target, const std::string& run_id);
    /// Removes the folder of the run unless it has been published or is kept.
    ~ResultFolder();
    ResultFolder(const ResultFolder&) = delete;
    ResultFolder& operator=(const ResultFolder&) = delete;

    /// Where the run writes.
    const std::filesystem::path& path() const { return path_; }
    /// What was found beside the target: runs that write into it now, or were killed.
    const std::vector<std::string>& notes() const { return notes_; }

    /// Takes the target's place. The earlier result is removed after that.
    /// @param durable  waits until the disk has everything, so that a power cut leaves one of both results whole
    /// @throws IoError; the earlier result is then as it was, and the new one stays where it is
    void publish(bool durable);
    /// The folder stays where it is.
    void keep() { kept_ = true; }

  private:
    void look_around();
    void take_place();

    std::filesystem::path target_, path_;
    int lock_ = -1;  ///< held while the run lives, so that others can tell
    bool kept_ = false;
    std::vector<std::string> notes_;
};

}  // namespace type21
