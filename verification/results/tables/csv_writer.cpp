#include "verification/results/tables/csv_writer.h"

#include <stdexcept>

#include <fmt/format.h>

namespace type21 {

std::string digits17(double value) {
    return fmt::format("{:.17g}", value);
}

CsvWriter::CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& header)
    : path_(path), file_(path, std::ios::binary | std::ios::trunc) {
    if (!file_) throw std::runtime_error(fmt::format("{}: cannot be written", path.string()));
    file_ << fmt::format("{}\n", fmt::join(header, ","));
    flush();
}

void CsvWriter::row(const std::vector<std::string>& lead, const std::vector<double>& values) {
    fmt::memory_buffer line;
    fmt::format_to(std::back_inserter(line), "{}", fmt::join(lead, ","));
    for (const double value : values)
        fmt::format_to(std::back_inserter(line), ",{:.17g}", value);
    line.push_back('\n');
    file_.write(line.data(), static_cast<std::streamsize>(line.size()));
}

void CsvWriter::flush() {
    file_.flush();
    if (!file_) throw std::runtime_error(fmt::format("{}: writing failed (disk full?)", path_.string()));
}

}  // namespace type21
