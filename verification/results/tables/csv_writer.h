/// @file A CSV file that keeps every row written, whatever happens to the run.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace type21 {

/// A double with the 17 significant digits that give back the same double.
std::string digits17(double value);

class CsvWriter {
  public:
    /// @throws std::runtime_error naming the file when it cannot be written.
    CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& header);

    /// One row; `lead` are the cells before the values, already text.
    void row(const std::vector<std::string>& lead, const std::vector<double>& values);
    /// To the disk. @throws std::runtime_error when the disk did not take it.
    void flush();

  private:
    std::filesystem::path path_;
    std::ofstream file_;
};

}  // namespace type21
