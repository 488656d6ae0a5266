/// @file A CSV file that is written row by row.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/contract/mesh.h"
#include "verification/support/output_file.h"

namespace type21 {

/// A double with the 17 significant digits that give back the same double.
std::string digits17(double value);

/// What has been written to a file of a result so far.
struct WrittenFile {
    std::string name;         ///< in its folder
    std::uint64_t bytes = 0;  ///< from the beginning
    std::string checksum;     ///< of these bytes; @see Checksum
};

/// A header line, rows, and at the end one line that says which run wrote them.
class CsvWriter {
  public:
    /// @param header  "time", "node", "rbody" or "element" where rows have an object, then the values. A file that is
    /// there already is that of a run which is gone on with: the header is in it.
    /// @throws IoError
    CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& header);

    /// One row of an object, or of none.
    /// @param time  as text, since many rows have the same
    /// @throws std::logic_error naming the column of a value that is not finite, IoError
    void row(std::string_view time, std::optional<Id> object, const std::vector<double>& values);
    /// To the system. @throws IoError
    void flush() { file_.flush(); }
    /// Adds the last line and closes the file. @throws IoError
    void close(std::string_view last_line);

    WrittenFile written() const { return {file_.path().filename().string(), file_.bytes(), file_.checksum()}; }

  private:
    std::vector<std::string> header_;
    OutputFile file_;
    std::string line_;
};

}  // namespace type21
