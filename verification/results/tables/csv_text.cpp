#include "verification/results/tables/csv_text.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <vector>

#include <fmt/format.h>

namespace type21 {
namespace {

std::string_view without_blanks(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

/// One line at a time; LF, CRLF and CR end one.
class Lines {
  public:
    explicit Lines(std::string_view text) : text_(text) {}

    bool at_end() const { return at_ >= text_.size(); }
    size_t number() const { return number_; }
    size_t at() const { return at_; }
    void move_to(size_t at, size_t lines) {
        at_ = at;
        number_ += lines;
    }
    /// The next line without its end.
    std::string_view peek() const {
        return text_.substr(at_, std::min(text_.find_first_of("\r\n", at_), text_.size()) - at_);
    }
    /// Index behind the end of line at `at`.
    static size_t behind_end(std::string_view text, size_t at) {
        if (at >= text.size()) return text.size();
        return at + (text.substr(at, 2) == "\r\n" ? 2 : 1);
    }
    std::string_view next() {
        const std::string_view line = peek();
        at_ = behind_end(text_, at_ + line.size());
        ++number_;
        return line;
    }

  private:
    std::string_view text_;
    size_t at_ = 0;
    size_t number_ = 1;
};

bool is_comment(std::string_view line) {
    return without_blanks(line).starts_with('#');
}

/// Outside quotes.
bool has_separator(std::string_view line, char separator) {
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (c == separator && !quoted) return true;
    }
    return false;
}

char separator_of(std::string_view header) {
    for (const char separator : {';', '\t'})
        if (has_separator(header, separator)) return separator;
    return ',';
}

/// time, "Time [s]", ...
bool names_the_time(std::string_view header) {
    if (header.starts_with('"')) header.remove_prefix(1);
    constexpr std::string_view time = "time";
    return header.size() >= time.size() && std::equal(time.begin(), time.end(), header.begin(), [](char a, char b) {
               return a == std::tolower(static_cast<unsigned char>(b));
           });
}

bool begins_with_a_number(std::string_view line) {
    line = without_blanks(line);
    if (line.starts_with('"')) line.remove_prefix(1);
    if (line.starts_with('+') || line.starts_with('-')) line.remove_prefix(1);
    return !line.empty() && (std::isdigit(static_cast<unsigned char>(line[0])) != 0 || line[0] == '.');
}

/// The cells of one row; quotes may carry it over several lines.
class RowReader {
  public:
    RowReader(std::string_view text, char separator, const std::string& file)
        : text_(text), separator_(separator), file_(file) {}

    /// @return index behind the row
    size_t read(size_t at, size_t line) {
        cells_.clear();
        unescaped_.clear();
        lines_ = 0;
        while (true) {
            while (at < text_.size() && text_[at] == ' ')
                ++at;
            if (at < text_.size() && text_[at] == '"') {
                at = quoted(at + 1, line);
            } else {
                const size_t end = std::min(text_.find_first_of(ends(), at), text_.size());
                cells_.push_back(without_blanks(text_.substr(at, end - at)));
                at = end;
            }
            if (at >= text_.size() || text_[at] != separator_) break;
            ++at;
        }
        ++lines_;
        return Lines::behind_end(text_, at);
    }
    const std::vector<std::string_view>& cells() const { return cells_; }
    size_t lines() const { return lines_; }

  private:
    std::string_view ends() const { return separator_ == ',' ? ",\r\n" : (separator_ == ';' ? ";\r\n" : "\t\r\n"); }

    size_t quoted(size_t at, size_t line) {
        const size_t begin = at;
        bool doubled = false;
        while (true) {
            const size_t quote = text_.find('"', at);
            if (quote == std::string_view::npos)
                throw CsvError(fmt::format("{}:{}: a quote is not closed", file_, line));
            at = quote + 1;
            if (at >= text_.size() || text_[at] != '"') break;
            doubled = true;
            ++at;
        }
        const std::string_view inside = text_.substr(begin, at - 1 - begin);
        lines_ += static_cast<size_t>(std::count(inside.begin(), inside.end(), '\n'));
        if (doubled) {
            std::string& plain = unescaped_.emplace_back();
            for (size_t i = 0; i < inside.size(); ++i) {
                plain += inside[i];
                if (inside[i] == '"') ++i;
            }
            cells_.push_back(without_blanks(plain));
        } else {
            cells_.push_back(without_blanks(inside));
        }
        const size_t end = std::min(text_.find_first_of(ends(), at), text_.size());
        if (!without_blanks(text_.substr(at, end - at)).empty())
            throw CsvError(fmt::format("{}:{}: text behind a closing quote; write a quote inside quotes twice", file_,
                                       line + lines_));
        return end;
    }

    std::string_view text_;
    char separator_;
    const std::string& file_;
    std::vector<std::string_view> cells_;
    std::deque<std::string> unescaped_;  ///< grows without moving what the cells refer to
    size_t lines_ = 0;
};

void require_plain_text(std::string_view text, const std::string& file) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw CsvError(fmt::format("{}: is UTF-16; save it as UTF-8", file));
    if (const size_t nul = text.find('\0'); nul != std::string_view::npos)
        throw CsvError(fmt::format("{}: byte {}: is no text (a NUL); save the table as CSV in UTF-8", file, nul));
}

}  // namespace

CsvText::CsvText(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
    require_plain_text(text_, file_);
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    Lines lines(text_);
    while (!lines.at_end()) {
        const std::string_view line = lines.peek();
        const std::string_view bare = without_blanks(line);
        if (bare.starts_with("sep=") && bare.size() == 5) {
            separator_ = bare[4];
            if (separator_ != ',' && separator_ != ';' && separator_ != '\t')
                throw CsvError(
                    fmt::format("{}:{}: the separator may be a comma, a semicolon or a tab", file_, lines.number()));
            text_.remove_prefix(lines.at() + line.size());
            header_line_ = 0;
            return;
        }
        if (is_comment(line)) {
            const std::string_view comment =
                without_blanks(bare.substr(std::min(bare.find_first_not_of('#'), bare.size())));
            if (names_the_time(comment)) {
                header_ = comment;
                header_line_ = lines.number();
            }
        } else if (!bare.empty()) {
            header_in_comment_ = begins_with_a_number(line) && !header_.empty();
            separator_ = separator_of(header_in_comment_ ? header_ : line);
            return;
        }
        lines.next();
    }
    throw CsvError(fmt::format("{}: is empty", file_));
}

void CsvText::each_row(const CsvRow& row) const {
    if (header_in_comment_) {
        RowReader header(header_, separator_, file_);
        header.read(0, header_line_);
        row(header_line_, header.cells());
    }
    RowReader reader(text_, separator_, file_);
    Lines lines(text_);
    while (!lines.at_end()) {
        const std::string_view line = lines.peek();
        if (is_comment(line) || without_blanks(line).empty()) {
            lines.next();
            continue;
        }
        const size_t number = lines.number();
        const size_t behind = reader.read(lines.at(), number);
        row(number, reader.cells());
        lines.move_to(behind, reader.lines());
    }
}

}  // namespace type21
