#include "verification/results/tables/csv_writer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace type21 {
namespace {

/// The same text as "%.17g".
void append(std::string& text, double value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 17);
    text.append(digits.data(), end.ptr);
}

OutputFile::Start start_of(const std::filesystem::path& path) {
    return std::filesystem::exists(std::filesystem::symlink_status(path)) ? OutputFile::Start::append
                                                                          : OutputFile::Start::create;
}

}  // namespace

std::string digits17(double value) {
    std::string text;
    append(text, value);
    return text;
}

CsvWriter::CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& header)
    : header_(header), file_(path, start_of(path)) {
    if (file_.bytes() > 0) return;
    file_.write(fmt::format("{}\n", fmt::join(header, ",")));
    file_.flush();
}

void CsvWriter::row(std::string_view time, std::optional<Id> object, const std::vector<double>& values) {
    line_ = time;
    if (object) line_ += fmt::format(",{}", *object);
    for (size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i]))
            throw std::logic_error(fmt::format(
                "{}: column {}{} would be {} at time {}", file_.path().string(), header_.at(i + (object ? 2 : 1)),
                object ? fmt::format(" of {} {}", header_.at(1), *object) : "", values[i], time));
        line_ += ',';
        append(line_, values[i]);
    }
    line_ += '\n';
    file_.write(line_);
}

void CsvWriter::close(std::string_view last_line) {
    file_.write(last_line);
    file_.close();
}

}  // namespace type21
