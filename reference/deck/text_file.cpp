#include "reference/deck/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/foreign_format.h"

namespace type21 {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t piece_bytes = std::size_t{8} << 20;

/// Tells binary content from text: a NUL, or more control characters than a slip of an editor explains.
class BinaryTest {
  public:
    void add(std::string_view text) {
        std::size_t zeros = 0;
        std::size_t controls = 0;
        for (const char c : text) {
            const auto byte = static_cast<unsigned char>(c);
            const bool harmless = byte >= 32 || (byte >= '\t' && byte <= '\r') || byte == 0x1A;
            controls += harmless ? 0 : 1;
            zeros += byte == 0 ? 1 : 0;
        }
        zeros_ += zeros;
        controls_ += controls;
        size_ += text.size();
    }
    bool is_binary() const { return zeros_ > 0 || controls_ > 8 || controls_ * 50 > size_; }

  private:
    std::size_t zeros_ = 0;
    std::size_t controls_ = 0;
    std::size_t size_ = 0;
};

std::string without_tabs(std::string_view text) {
    std::string out;
    out.reserve(text.size() + text.size() / 4);
    std::size_t column = 0;
    for (const char c : text) {
        if (c == '\t') {
            const std::size_t blanks = tab_stop - column % tab_stop;
            out.append(blanks, ' ');
            column += blanks;
        } else {
            out.push_back(c);
            column = (c == '\n' || c == '\r') ? 0 : column + 1;
        }
    }
    return out;
}

/// Files below /proc and /sys claim to be ordinary ones of no or any size; some never end, some wait for ever.
bool is_of_the_system(const std::string& path) {
    std::error_code code;
    const std::string real = fs::weakly_canonical(path, code).string();
    return real.starts_with("/proc/") || real.starts_with("/sys/") || real.starts_with("/dev/");
}

/// What is wrong with a file before it is opened; empty: nothing.
std::string fault_of(const std::string& path) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (is_of_the_system(path)) return "this is a special file of the system, not an ordinary file";
    if (!fs::exists(status)) return "there is no such file";
    if (fs::is_directory(status)) return "this is a folder, not a file";
    if (!fs::is_regular_file(status)) return "this is not an ordinary file";
    if (fs::file_size(path, code) > max_bytes) return "the file is larger than 2 GB";
    return {};
}

std::nullopt_t refuse(const std::string& path, Problem problem, Problems& problems, const std::string& rule,
                      const std::string& remedy) {
    problem.value = path;
    problem.rule = rule;
    problem.remedy = remedy;
    problems.add(std::move(problem));
    return std::nullopt;
}

/// Makes a TextFile of the pieces of a file.
class TextBuilder {
  public:
    TextBuilder(const std::string& path, TextKind kind, const Problem& blame, Problems& problems)
        : path_(path), kind_(kind), blame_(blame), problems_(problems) {}

    /// A look at the beginning of the file; false and an error when it is another program's.
    bool begin(std::string& bytes, std::uintmax_t size) {
        std::string name = kind_ == TextKind::deck ? foreign_format(bytes, path_, size) : "";
        if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
        if (name.empty()) return true;
        std::string remedy = "Give a Radioss deck: its cards begin with '/' in column 1";
        if (const std::size_t colon = name.find(": "); colon != std::string::npos) {
            remedy = upper(name.substr(colon + 2, 1)) + name.substr(colon + 3);
            name.resize(colon);
        }
        refuse(path_, blame_, problems_, fmt::format("this is {}, not a Radioss deck", name), remedy);
        return false;
    }

    void add(std::string bytes) {
        binary_.add(bytes);
        has_line_feed_ = has_line_feed_ || bytes.find('\n') != std::string::npos;
        if (bytes.find('\t') != std::string::npos) bytes = without_tabs(bytes);
        file_.size += bytes.size();
        file_.pieces.push_back(std::make_shared<const std::string>(std::move(bytes)));
    }

    std::optional<TextFile> end() {
        if (binary_.is_binary())
            return refuse(path_, blame_, problems_, "the file is binary, not text",
                          "Save the deck as plain text (ASCII or UTF-8)");
        file_.line_end = has_line_feed_ ? '\n' : '\r';
        return std::move(file_);
    }

  private:
    const std::string& path_;
    TextKind kind_;
    const Problem& blame_;
    Problems& problems_;
    TextFile file_;
    BinaryTest binary_;
    bool has_line_feed_ = false;
};

/// Reads a file in pieces that end with a line. False: it cannot be read, or begin() has refused it.
bool read_pieces(std::FILE* file, std::uintmax_t size, TextBuilder& builder, bool& failed) {
    std::string rest;  // of a line that goes on in the next piece
    std::uintmax_t left = size;
    for (bool first = true, last = false; !last; first = false) {
        std::string bytes = std::exchange(rest, {});
        const std::size_t kept = bytes.size();
        const auto wanted = static_cast<std::size_t>(std::min<std::uintmax_t>(piece_bytes, left + 1));
        bytes.resize(kept + wanted);
        const std::size_t got = std::fread(bytes.data() + kept, 1, wanted, file);
        bytes.resize(kept + got);
        left -= std::min<std::uintmax_t>(left, got);
        last = got < wanted;
        failed = std::ferror(file) != 0;
        if (failed || (first && !builder.begin(bytes, size))) return false;
        if (!last) {
            const std::size_t end = bytes.rfind('\n') + 1;
            if (end == 0) {
                rest = std::move(bytes);
                continue;
            }
            rest.assign(bytes, end);
            bytes.resize(end);
        }
        builder.add(std::move(bytes));
    }
    return true;
}

}  // namespace

bool LineReader::next(std::string_view& line) {
    while (piece_ < file_.pieces.size() && at_ >= file_.pieces[piece_]->size()) {
        ++piece_;
        at_ = 0;
    }
    if (piece_ == file_.pieces.size()) return false;
    const std::string_view rest = std::string_view(*file_.pieces[piece_]).substr(at_);
    const std::size_t end = std::min(rest.find(file_.line_end), rest.size());
    std::size_t length = end;
    while (length > 0 && (rest[length - 1] == ' ' || rest[length - 1] == '\r' || rest[length - 1] == '\f' ||
                          rest[length - 1] == '\v' || rest[length - 1] == '\x1A'))
        --length;
    line = rest.substr(0, length);
    at_ += end + 1;
    return true;
}

std::optional<TextFile> text_of(std::string bytes, const std::string& path, const Problem& blame, Problems& problems) {
    TextBuilder builder(path, TextKind::deck, blame, problems);
    if (!builder.begin(bytes, bytes.size())) return std::nullopt;
    builder.add(std::move(bytes));
    return builder.end();
}

std::optional<TextFile> load_text(const std::string& path, const Problem& blame, Problems& problems, TextKind kind) {
    const std::string remedy = "Give the path of a readable text file";
    if (const std::string fault = fault_of(path); !fault.empty()) return refuse(path, blame, problems, fault, remedy);
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr)
        return refuse(path, blame, problems, std::string("the file cannot be opened: ") + std::strerror(errno), remedy);
    std::error_code code;
    TextBuilder builder(path, kind, blame, problems);
    bool failed = false;
    const bool whole = read_pieces(file, fs::file_size(path, code), builder, failed);
    std::fclose(file);
    if (failed) return refuse(path, blame, problems, "the file cannot be read", remedy);
    if (!whole) return std::nullopt;
    return builder.end();
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return out;
}

}  // namespace type21
