#include "reference/host/thickness_history.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/text_file.h"
#include "reference/model/numbers.h"

namespace type21 {

namespace {

std::vector<std::string_view> cells(std::string_view line) {
    std::vector<std::string_view> out;
    for (size_t begin = 0; begin <= line.size();) {
        const size_t comma = std::min(line.find(',', begin), line.size());
        out.push_back(trimmed(line.substr(begin, comma - begin)));
        begin = comma + 1;
    }
    return out;
}

/// Says what is wrong with a line of one file.
struct Complaint {
    const std::string& path;
    Problems& problems;

    void operator()(int line, std::string_view field, std::string_view value, std::string rule,
                    std::string remedy) const {
        problems.add({Severity::error,
                      {path, line},
                      "",
                      std::string(field),
                      std::string(value),
                      std::move(rule),
                      std::move(remedy)});
    }
};

/// Index of a shell by its id, -1 where a quad and a triangle share it.
std::unordered_map<Id, int> shells_by_id(const Model& model) {
    std::unordered_map<Id, int> index;
    for (size_t i = 0; i < model.shells.size(); ++i) {
        const auto [found, is_new] = index.emplace(model.shells[i].id, static_cast<int>(i));
        if (!is_new) found->second = -1;
    }
    return index;
}

/// Shell of each column, -1 where the column names none.
std::vector<int> read_header(const std::vector<std::string_view>& header, int line, const Model& model,
                             const Complaint& complain) {
    if (header.front() != "time")
        complain(line, "time", header.front(), "the first line is time,<element id>,...",
                 "Write the names of the columns there");
    if (header.size() < 2)
        complain(line, "", "", "the table has no column of an element", "Add a column for each element that changes");
    const std::unordered_map<Id, int> index = shells_by_id(model);
    std::vector<int> columns;
    std::vector<bool> named(model.shells.size(), false);
    for (size_t column = 1; column < header.size(); ++column) {
        Id id = 0;
        const bool number = parse_integer(header[column], id) == NumberFault::none;
        const auto found = number ? index.find(id) : index.end();
        int shell = -1;
        if (found == index.end()) {
            complain(line, "element id", header[column], "there is no shell with this id",
                     "Give the id of a /SHELL or /SH3N of the deck");
        } else if (found->second < 0) {
            complain(line, "element id", header[column], "a /SHELL and a /SH3N share this id",
                     "Give them ids of their own");
        } else if (named[static_cast<size_t>(found->second)]) {
            complain(line, "element id", header[column], "the element has a column already",
                     "Give each element one column");
        } else {
            shell = found->second;
            named[static_cast<size_t>(shell)] = true;
        }
        columns.push_back(shell);
    }
    return columns;
}

/// The numbers of one row; none when one of them is wrong.
std::optional<std::vector<double>> read_row(const std::vector<std::string_view>& row, int line,
                                            const std::vector<std::string_view>& header, const Complaint& complain) {
    if (row.size() != header.size()) {
        complain(line, "", fmt::format("{} values", row.size()),
                 fmt::format("a row has {} values, one a column", header.size()), "Complete the row");
        return std::nullopt;
    }
    bool good = true;
    std::vector<double> values;
    for (size_t column = 0; column < row.size(); ++column) {
        double value = 0;
        if (parse_real(row[column], value) != NumberFault::none) {
            complain(line, header[column], row[column], "this is not a number", "Give a number such as 1.5e-3");
            good = false;
        } else if (column > 0 && value < 0) {
            complain(line, header[column], row[column], "a thickness is not negative", "Give 0 for a deleted element");
            good = false;
        }
        values.push_back(value);
    }
    return good ? std::optional(values) : std::nullopt;
}

}  // namespace

ThicknessHistory ThicknessHistory::read(const std::string& path, const Model& model, Problems& problems) {
    ThicknessHistory history;
    const Complaint complain{path, problems};
    Problem blame;
    blame.field = "--thickness";
    const std::optional<TextFile> file = load_text(path, blame, problems);
    if (!file) return history;
    std::vector<std::string_view> header;
    std::vector<int> columns;
    double last = 0;
    bool has_rows = false;
    LineReader lines(*file);
    std::string_view text;
    for (int line = 1; lines.next(text); ++line) {
        if (trimmed(text).empty()) continue;
        const std::vector<std::string_view> words = cells(text);
        if (header.empty()) {
            header = words;
            columns = read_header(header, line, model, complain);
            std::copy_if(columns.begin(), columns.end(), std::back_inserter(history.shells_),
                         [](int shell) { return shell >= 0; });
            continue;
        }
        std::optional<std::vector<double>> values = read_row(words, line, header, complain);
        const bool later = !has_rows || !values || values->front() > last;
        if (!later)
            complain(line, "time", words.front(), "the times of the rows ascend",
                     fmt::format("Give a time after {}", last));
        has_rows = true;
        if (!values || !later) continue;
        last = values->front();
        history.times_.push_back(last);
        std::vector<double>& thickness = history.rows_.emplace_back();
        for (size_t column = 0; column < columns.size(); ++column)
            if (columns[column] >= 0) thickness.push_back((*values)[column + 1]);
    }
    if (header.empty())
        complain(0, "", "", "the file is empty", "Write time,<element id>,... and the rows");
    else if (!has_rows)
        complain(0, "", "", "the table has no row", "Add a row for at least one time");
    return history;
}

void ThicknessHistory::at(double time, std::vector<double>& thickness) const {
    constexpr double same = 1e-6;  ///< of the row spacing: a sum of steps does not meet a printed time to the last bit
    if (rows_.empty()) return;
    const auto take = [&](auto&& value) {
        for (size_t column = 0; column < shells_.size(); ++column)
            thickness[static_cast<size_t>(shells_[column])] = value(column);
    };
    const auto above = static_cast<size_t>(std::upper_bound(times_.begin(), times_.end(), time) - times_.begin());
    if (above == 0) return take([&](size_t column) { return rows_.front()[column]; });
    if (above == times_.size()) return take([&](size_t column) { return rows_.back()[column]; });
    const double spacing = times_[above] - times_[above - 1];
    const double share = (time - times_[above - 1]) / spacing;
    if (share <= same) return take([&](size_t column) { return rows_[above - 1][column]; });
    if (share >= 1 - same) return take([&](size_t column) { return rows_[above][column]; });
    take([&](size_t column) {
        const double before = rows_[above - 1][column];
        return before + share * (rows_[above][column] - before);
    });
}

}  // namespace type21
