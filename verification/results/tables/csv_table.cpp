#include "verification/results/tables/csv_table.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "verification/results/tables/csv_number.h"
#include "verification/support/shown_text.h"

namespace type21 {
namespace {

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string_view without_outer_blanks(std::string_view text) {
    while (text.starts_with(' '))
        text.remove_prefix(1);
    while (text.ends_with(' '))
        text.remove_suffix(1);
    return text;
}

/// Fills a table row by row.
class TableReader {
  public:
    TableReader(CsvTable& table, const CsvReading& reading, char separator)
        : table_(table), reading_(reading), separator_(separator), numbers_(separator != ',') {}

    void row(size_t line, std::span<const std::string_view> cells) {
        if (header_line_ == 0) {
            header_line_ = line;
            read_header(line, cells);
        } else {
            read_values(line, cells);
        }
    }

    void finish() {
        if (const std::string fault = numbers_.fault(); !fault.empty())
            throw CsvError(fmt::format("{}: {}", table_.file, fault));
        if (numbers_.has_decimal_comma()) table_.notes.emplace_back("commas in numbers are read as decimal commas");
        const int digits = numbers_.printed_digits();
        if (digits == 0) return;
        table_.rounding = 0.5 * std::pow(10.0, 1 - digits);
        table_.rounded_to = fmt::format("{} digits", digits);
    }

  private:
    [[noreturn]] void fail(size_t line, const std::string& what) const {
        throw CsvError(fmt::format("{}:{}: {}", table_.file, line, what));
    }

    void read_header(size_t line, std::span<const std::string_view> cells) {
        if (cells.size() > 1 && cells.back().empty()) cells = cells.first(cells.size() - 1);
        width_ = cells.size();
        if (cells.size() > 1 && cells.front().empty()) {
            skip_ = 1;
            table_.notes.emplace_back("the first column has no name and is left out");
            cells = cells.subspan(1);
        }
        const auto [time, time_unit] = name_and_unit(cells.front());
        if (!same_word(time, reading_.time_name))
            fail(line,
                 fmt::format("the first column must be '{}'; it is '{}'", reading_.time_name, shown(cells.front())));
        table_.time_unit = time_unit;
        for (const char* object : {"node", "rbody", "element"}) {
            if (cells.size() < 2 || !same_word(cells[1], object)) continue;
            table_.has_object = true;
            table_.object_name = object;
        }
        lead_ = table_.has_object ? 2 : 1;
        bool has_units = false;
        for (const std::string_view cell : cells.subspan(lead_)) {
            const auto [name, unit] = name_and_unit(cell);
            table_.columns.push_back(shown(name, 400));
            table_.units.push_back(shown(unit));
            has_units = has_units || !unit.empty();
        }
        if (!has_units) table_.units.clear();
        table_.values.resize(table_.columns.size());
        if (reading_.unique_names) require_unique_names(line);
    }

    void require_unique_names(size_t line) const {
        std::vector<std::string> sorted = table_.columns;
        std::sort(sorted.begin(), sorted.end());
        const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
        if (twice != sorted.end()) fail(line, fmt::format("column '{}' is there twice", shown(*twice)));
    }

    void read_values(size_t line, std::span<const std::string_view> cells) {
        if (cells.size() == width_ + 1 && cells.back().empty()) cells = cells.first(width_);
        if (cells.size() != width_) {
            const bool commas = separator_ == ',' && cells.size() > width_;
            fail(line, fmt::format("{} cells where the header has {}{}", cells.size(), width_,
                                   commas ? "; a table with decimal commas needs ';' between its cells" : ""));
        }
        cells = cells.subspan(skip_);
        table_.time.push_back(number(numbers_.read(cells[0], line), cells[0], line));
        if (!std::isfinite(table_.time.back())) fail(line, fmt::format("time {} is not finite", shown(cells[0])));
        if (table_.has_object) table_.object.push_back(id(cells[1], line));
        for (size_t c = 0; c < table_.columns.size(); ++c)
            table_.values[c].push_back(number(numbers_.read_value(cells[c + lead_], line), cells[c + lead_], line));
    }

    double number(std::optional<double> value, std::string_view cell, size_t line) const {
        if (!value) fail(line, fmt::format("'{}' is not a number", shown(cell)));
        return *value;
    }

    /// pandas writes ids beside empty cells as 7.0.
    Id id(std::string_view cell, size_t line) {
        constexpr double largest = 9e15;  // below it every whole number is a double
        const double value = number(numbers_.read(cell, line), cell, line);
        if (!(std::abs(value) < largest) || value != std::floor(value))
            fail(line, fmt::format("{} '{}' is not an id; ids are whole numbers", table_.object_name, shown(cell)));
        return static_cast<Id>(value);
    }

    CsvTable& table_;
    const CsvReading& reading_;
    char separator_;
    CsvNumbers numbers_;
    size_t header_line_ = 0, width_ = 0, skip_ = 0, lead_ = 1;
};

}  // namespace

std::optional<size_t> CsvTable::column(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end()) return std::nullopt;
    return static_cast<size_t>(found - columns.begin());
}

NameAndUnit name_and_unit(std::string_view header) {
    const auto split = [&](size_t at, size_t width, size_t end) {
        return NameAndUnit{std::string(without_outer_blanks(header.substr(0, at))),
                           std::string(without_outer_blanks(header.substr(at + width, end - at - width)))};
    };
    for (const auto& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}}) {
        const size_t at = header.rfind(open);
        if (at == std::string_view::npos || at == 0 || !header.ends_with(close)) continue;
        const std::string_view inside = header.substr(at + 1, header.size() - at - 2);
        // "FNX (1)" is the interface 1.
        const bool is_number = inside.find_first_not_of("0123456789 ") == std::string_view::npos;
        if (!is_number) return split(at, 1, header.size() - 1);
    }
    if (const size_t at = header.find(" / "); at != std::string_view::npos && at > 0)
        return split(at, 3, header.size());
    if (header.size() > 5 && same_word(header.substr(0, 5), "time/")) return split(4, 1, header.size());
    return {std::string(header), ""};
}

CsvTable read_csv(const std::filesystem::path& path, const CsvReading& reading) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    CsvTable table;
    table.file = path.string();
    if (!file || std::filesystem::is_directory(path)) throw CsvError(fmt::format("{}: cannot be read", table.file));
    const CsvText csv(text, table.file);
    TableReader reader(table, reading, csv.separator());
    if (csv.separator() != ',')
        table.notes.push_back(
            fmt::format("the cells are separated by {}", csv.separator() == ';' ? "semicolons" : "tabs"));
    if (csv.header_in_comment()) table.notes.emplace_back("the header is a comment line");
    csv.each_row([&](size_t line, std::span<const std::string_view> cells) { reader.row(line, cells); });
    reader.finish();
    return table;
}

CsvTable filtered(const CsvTable& table, const TimeWindow& window, const std::vector<Id>& objects) {
    CsvTable out;
    static_cast<CsvHeading&>(out) = table;
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
