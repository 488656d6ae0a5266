/// @file The list of a time series (.pvd): which file belongs to which time.
#pragma once

#include <filesystem>
#include <string>

namespace type21 {

/// Grows by one entry a time and is whole after each: an entry and the end of the list are written over the old end.
/// When that fails, the old end is put back.
class PvdFile {
  public:
    /// An empty list.
    /// @param mark  a line of XML that says which run wrote it, or nothing
    /// @throws IoError
    explicit PvdFile(const std::filesystem::path& path, const std::string& mark = "");

    /// @param file  name, relative to the folder of the list
    /// @throws IoError; the list is then as it was
    void add(double time, const std::string& file);

  private:
    /// Opens and closes the file: a stream that failed would try what it holds again.
    bool write_at_end(const std::string& text) const;

    std::filesystem::path path_;
    std::streamoff end_ = 0;  ///< where the next entry goes [byte]
};

}  // namespace type21
