#include "verification/results/record/run_id.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "verification/results/record/result_files.h"
#include "verification/support/output_file.h"

namespace type21 {
namespace fs = std::filesystem;
namespace {

constexpr std::streamoff mark_size = 256;  ///< a mark lies within so many bytes of its end of the file

/// The first or the last bytes of a file.
std::string end_of(const fs::path& path, bool last) {
    std::ifstream file(path, std::ios::binary);
    if (last) {
        file.seekg(0, std::ios::end);
        const std::streamoff size = file.tellg();
        file.seekg(std::max<std::streamoff>(0, size - mark_size));
    }
    std::string text(static_cast<size_t>(mark_size), '\0');
    file.read(text.data(), mark_size);
    text.resize(static_cast<size_t>(file.gcount()));
    return text;
}

}  // namespace

std::string new_run_id() {
    std::string digits = random_digits(32);
    digits[12] = '4';
    const size_t variant = std::string_view("0123456789abcdef").find(digits[16]);
    digits[16] = "89ab"[variant % 4];
    for (const size_t at : {20U, 16U, 12U, 8U})
        digits.insert(at, "-");
    return digits;
}

std::string csv_mark(std::string_view run_id) {
    return fmt::format("# type21 schema {} run {}\n", result_schema, run_id);
}

std::string xml_mark(std::string_view run_id) {
    return fmt::format("<!-- type21 schema {} run {} -->\n", result_schema, run_id);
}

std::string run_id_in(const fs::path& file) {
    const bool csv = file.extension() == ".csv";
    const std::string text = end_of(file, csv);
    const std::string_view before = csv ? "# type21 schema " : "<!-- type21 schema ";
    const size_t mark = csv ? text.rfind(before) : text.find(before);
    if (mark == std::string::npos) return "";
    const size_t run = text.find(" run ", mark);
    if (run == std::string::npos || run > text.find('\n', mark)) return "";
    const size_t begin = run + 5;
    return text.substr(begin, text.find_first_of(" \r\n", begin) - begin);
}

RunFolderCheck check_run_id(const fs::path& folder) {
    RunFolderCheck check;
    const std::optional<RunMark> run = read_run_mark(folder);
    if (!run) return check;
    check.is_run = true;
    check.run_id = run->run_id;
    check.status = run->status;
    if (check.run_id.empty()) return check;
    for (const fs::path& file : marked_files(folder)) {
        const std::string id = run_id_in(file);
        if (id == check.run_id) continue;
        check.problems.push_back(id.empty() ? fmt::format("{}: no run id: it is not whole, or not of the run in {}",
                                                          file.string(), (folder / "run.json").string())
                                            : fmt::format("{}: of run {}, but {} is of run {}", file.string(), id,
                                                          (folder / "run.json").string(), check.run_id));
    }
    std::sort(check.problems.begin(), check.problems.end());
    return check;
}

}  // namespace type21
