#include "reference/deck/deck_files.h"

#include <filesystem>

namespace type21 {

namespace {

namespace fs = std::filesystem;

}  // namespace

bool DiskFiles::exists(const std::string& path) const {
    std::error_code code;
    return fs::exists(path, code);
}

std::string DiskFiles::identity(const std::string& path) const {
    std::error_code code;
    const fs::path real = fs::weakly_canonical(path, code);
    return code ? path : real.string();
}

std::string DiskFiles::similar(const std::string& path) const {
    const fs::path wanted(path);
    const fs::path folder = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
    const std::string name = upper(wanted.filename().string());
    std::error_code code;
    for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
        std::string other = entry->path().filename().string();
        if (upper(other) == name) return other;
    }
    return {};
}

std::optional<TextFile> DiskFiles::load(const std::string& path, const Problem& blame, Problems& problems) const {
    return load_text(path, blame, problems, TextKind::deck);
}

bool MemoryFiles::exists(const std::string& path) const {
    return find(path) != nullptr;
}

std::string MemoryFiles::identity(const std::string& path) const {
    return fs::path(path).lexically_normal().string();
}

std::string MemoryFiles::similar(const std::string& path) const {
    const std::string wanted = upper(identity(path));
    for (const MemoryFile& file : files_) {
        if (upper(identity(file.path)) == wanted) return file.path;
    }
    return {};
}

std::optional<TextFile> MemoryFiles::load(const std::string& path, const Problem& blame, Problems& problems) const {
    if (const MemoryFile* file = find(path)) return text_of(file->bytes, path, blame, problems);
    Problem problem = blame;
    problem.value = path;
    problem.rule = "there is no such file";
    problem.remedy = "Give the path of a readable text file";
    problems.add(problem);
    return std::nullopt;
}

const MemoryFile* MemoryFiles::find(const std::string& path) const {
    const std::string wanted = identity(path);
    for (const MemoryFile& file : files_) {
        if (identity(file.path) == wanted) return &file;
    }
    return nullptr;
}

}  // namespace type21
