#include "verification/results/tables/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace type21 {
namespace {

std::vector<std::string_view> cells(std::string_view line) {
    std::vector<std::string_view> out;
    while (true) {
        const size_t comma = line.find(',');
        std::string_view cell = line.substr(0, comma);
        while (!cell.empty() && cell.front() == ' ')
            cell.remove_prefix(1);
        while (!cell.empty() && cell.back() == ' ')
            cell.remove_suffix(1);
        out.push_back(cell);
        if (comma == std::string_view::npos) return out;
        line.remove_prefix(comma + 1);
    }
}

template <class Number>
Number parse(std::string_view cell, const std::string& file, size_t line) {
    Number value{};
    if (cell.starts_with('+')) cell.remove_prefix(1);
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size())
        throw CsvError(fmt::format("{}:{}: '{}' is not a number", file, line, cell));
    return value;
}

void read_header(CsvTable& table, std::string_view line) {
    const std::vector<std::string_view> names = cells(line);
    if (names.front() != "time") throw CsvError(fmt::format("{}:1: the first column must be 'time'", table.file));
    table.has_object = names.size() > 1 && (names[1] == "node" || names[1] == "rbody" || names[1] == "element");
    if (table.has_object) table.object_name = names[1];
    table.columns.assign(names.begin() + (table.has_object ? 2 : 1), names.end());
    std::vector<std::string> sorted = table.columns;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) throw CsvError(fmt::format("{}:1: column '{}' is there twice", table.file, *twice));
    table.values.resize(table.columns.size());
}

void read_row(CsvTable& table, std::string_view line, size_t number) {
    const std::vector<std::string_view> row = cells(line);
    const size_t lead = table.has_object ? 2 : 1;
    if (row.size() != table.columns.size() + lead)
        throw CsvError(fmt::format("{}:{}: {} cells where the header has {}", table.file, number, row.size(),
                                   table.columns.size() + lead));
    table.time.push_back(parse<double>(row[0], table.file, number));
    if (!std::isfinite(table.time.back()))
        throw CsvError(fmt::format("{}:{}: time {} is not finite", table.file, number, row[0]));
    if (table.has_object) table.object.push_back(parse<Id>(row[1], table.file, number));
    for (size_t c = 0; c < table.columns.size(); ++c)
        table.values[c].push_back(parse<double>(row[c + lead], table.file, number));
}

}  // namespace

std::optional<size_t> CsvTable::column(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end()) return std::nullopt;
    return static_cast<size_t>(found - columns.begin());
}

CsvTable read_csv(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    CsvTable table;
    table.file = path.string();
    if (!file) throw CsvError(fmt::format("{}: cannot be read", table.file));
    size_t number = 0;
    for (std::string_view rest = text; !rest.empty();) {
        const size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        ++number;
        if (number == 1) {
            read_header(table, line);
        } else if (!line.empty()) {
            read_row(table, line, number);
        }
    }
    if (number == 0) throw CsvError(fmt::format("{}: is empty", table.file));
    return table;
}

CsvTable filtered(const CsvTable& table, const TimeWindow& window, const std::vector<Id>& objects) {
    CsvTable out;
    out.file = table.file;
    out.has_object = table.has_object;
    out.object_name = table.object_name;
    out.columns = table.columns;
    out.rounding = table.rounding;
    out.values.resize(table.columns.size());
    for (size_t row = 0; row < table.rows(); ++row) {
        if (table.time[row] < window.from || table.time[row] > window.until) continue;
        if (table.has_object && !objects.empty() &&
            std::find(objects.begin(), objects.end(), table.object[row]) == objects.end())
            continue;
        out.time.push_back(table.time[row]);
        if (table.has_object) out.object.push_back(table.object[row]);
        for (size_t c = 0; c < out.values.size(); ++c)
            out.values[c].push_back(table.values[c][row]);
    }
    return out;
}

}  // namespace type21
